// The precompiled header of all rooms needs one file to be compiled with (CMakeLists.txt).
