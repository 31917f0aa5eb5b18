# From the headers' macros: the values of all enumerants, each once.
/^#define GL_[A-Z0-9_]+ (0x[0-9A-Fa-f]+|[0-9]+)$/ && !($3 in seen) { seen[$3] = 1; printf "%s,\n", $3 }
