/* The law of the controllers of these tests: it balances the pole of models/cart_pole.scene. y: its outputs. */
#ifndef TESTS_LINK_LAW_H
#define TESTS_LINK_LAW_H

#define LAW(y) (30 * (y)[2] + 6 * (y)[3] + 2 * (y)[0] + 4 * (y)[1])

#endif
