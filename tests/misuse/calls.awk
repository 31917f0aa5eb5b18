# From the preprocessed headers of OpenGL: a row CALL(name, arguments) for every command, with the maker of a random value (misuse.c) for
# each parameter. Whether a command takes pointers bounds its sizes: it reads as much as they say.
BEGIN { RS = ";" }

function target_group(name)
{
    if (name ~ /MultiTexCoord/)                        return "unit"
    if (name ~ /Image1D|TexStorage1D/)                              return "image1d"
    if (name ~ /Image2D|TexStorage2D/)                              return "image2d"
    if (name ~ /Image3D|TexStorage3D/)                              return "image3d"
    if (name ~ /GetTexImage|GetCompressed|TexLevel/)   return "image"
    if (name ~ /TexEnv/)                               return "environment"
    if (name ~ /TexParameter|BindTexture|GenerateMip/) return "texture"
    if (name ~ /Color(Sub)?Table/)                     return "table"
    if (name ~ /Convolution|Separable/)                return "filter"
    if (name ~ /Histogram/)                            return "histogram"
    if (name ~ /Minmax/)                               return "minmax"
    if (name ~ /Quer/)                                 return "query"
    if (name ~ /Renderbuffer/ && name !~ /Framebuffer/) return "renderbuffer"
    if (name ~ /Framebuffer/)                          return "framebuffer"
    if (name ~ /Buffer/)                               return "buffer_object"
    if (name ~ /Map.*1/)                               return "map1"
    if (name ~ /Map/)                                  return "map2"
    return ""
}

function pname_group(name)
{
    if (name ~ /TexGen/)                     return "generation"
    if (name ~ /Light|Material/)             return "light_pname"
    if (name ~ /PixelStore/)                 return "pixel_store"
    if (name ~ /PixelTransfer/)              return "pixel_transfer"
    if (name ~ /(Tex(Level)?|Sampler)Parameter/)       return "texture_pname"
    if (name ~ /TexEnv/)                     return "environment_pname"
    if (name ~ /Fog/)                        return "fog"
    if (name ~ /PointParameter/)             return "point"
    if (name ~ /ColorTable/)                 return "table_pname"
    if (name ~ /Convolution/)                return "filter_pname"
    if (name ~ /Histogram|Minmax/)           return "histogram_pname"
    if (name ~ /Query/)                      return "query_pname"
    if (name ~ /Attachment/)                 return "attachment_pname"
    if (name ~ /Renderbuffer/)               return "renderbuffer_pname"
    if (name ~ /Buffer/)                     return "buffer_pname"
    return ""
}

function mode_group(name)
{
    if (name ~ /Begin|Draw/)   return "primitive"
    if (name ~ /MatrixMode/)   return "matrix_mode"
    if (name ~ /PolygonMode|EvalMesh/) return "polygon_mode"
    return "mode"
}

function group(name, p)
{
    if (p == "target")                            return target_group(name)
    if (p == "pname")                             return pname_group(name)
    if (p ~ /^mode/)                              return mode_group(name)
    if (p == "internalformat")                    return "internal_format"
    if (p == "texture")                           return "unit"
    if (p == "textarget")                         return "image"
    if (p == "coord")                             return "coordinate"
    if (p == "map")                               return "pixel_map"
    if (p == "func")                              return "function"
    if (p ~ /^(fail|zfail|zpass)$/)               return "stencil_op"
    if (p ~ /factor/)                             return "factor"
    if (p == "opcode")                            return "logic_op"
    if (p ~ /^(buf|src)$/)                        return "buffer"
    if (name ~ /Hint/ && p == "target")           return "hint"
    if (name ~ /GetPointer/)                      return "pointer"
    if (p == "filter")                            return "magnification"
    if (p == "op")                                return "accumulation"
    if (p == "query")                             return "map_query"
    if (p == "name")                              return "string"
    if (p == "access")                            return "usage"
    if (p == "renderbuffertarget")                return "renderbuffer"
    if (p == "type" && name ~ /CopyPixels/)       return "copied"
    if (p ~ /^(array|cap|plane|light|face|format|type|usage|attachment)$/) return p
    return ""
}

function value(name, declared, p)
{
    if (declared ~ /\*[^*]*\*/)                         return "pointers()"
    if (declared ~ /\*/ && declared !~ /const/)         return "output()"
    if (declared ~ /\*/)                                return name ~ /Pointer|Arrays|Element|CallLists|Buffer|Data/ ? "indexes()" : "numbers()"
    if (declared ~ /GLenum/)                            return group(name, p) ? "ONE_OF(" group(name, p) ")" : "enumerant()"
    if (name ~ /PixelStore/ && p == "param")            return "small_integer()"
    if (p == "param")                                   return declared ~ /GLint/ ? "integer_parameter()" : "parameter()"
    if (p == "internalformat")                          return "ONE_OF(internal_format)"
    if (p ~ /^(level|border)$/)                         return p "()"
    if (declared ~ /GLbitfield/)                        return "bits()"
    if (declared ~ /GL(float|double|clamp)/)            return "number()"
    return bounded ? "small_integer()" : "integer()"
}

match($0, /gl[A-Z][A-Za-z0-9]*\(/) {
    text = substr($0, RSTART)
    gsub(/[\n\t ]+/, " ", text)
    name = substr(text, 1, index(text, "(") - 1)
    list = substr(text, index(text, "(") + 1)
    sub(/\)[^)]*$/, "", list)
    if (name in seen)
        next
    seen[name] = 1
    bounded = list ~ /\*/ || name ~ /Draw|Element|EvalMesh|EvalPoint|GenLists|BufferData|MapBuffer/
    count = list == "void" ? 0 : split(list, parameters, ",")
    arguments = ""
    for (i = 1; i <= count; i++) {
        type = p = parameters[i]
        sub(/^ */, "", type)
        sub(/[A-Za-z0-9_]*(\[[0-9]*\])?$/, "", type)
        match(p, /[A-Za-z0-9_]+$/)
        arguments = arguments ", (" type ")" value(name, p, substr(p, RSTART))
    }
    printf "CALL(%s, (%s))\n", name, substr(arguments, 3)
}
