# Prints "name value" for the number of one key in the program's JSON: awk -v key=rays -v name=path_rays [-v scale=1e-6]
{
    start = index($0, "\"" key "\":") + length(key) + 3
    number = substr($0, start) + 0
    printf "%s %.6g\n", name, number * (scale ? scale : 1)
}
