// The node as a process of its own.
#include "run_node.h"

int main(int argc, char** argv) { return ice_ice_baby::runNode(argc, argv); }
