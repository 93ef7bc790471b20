/* The program of every target. */
#include "core/application/run.h"

static iso_loop loop;

int main(int argc, char **argv)
{
    iso_run(&loop, iso_port_duration(argc, argv), NULL);
}
