/* eigenmotion generate jansen.py */
/* input sha256:ed5b383ebca52d6aef31c433b70cfaa858804fff4d43e6ad6bba3b16ee634350 */
/* body sha256:aa713d82ebe7e8c7635fa680fce664c01227d09ee3c4724ec0670f30d7048e32 */
/* jansen: 7 coordinates, 6 constraint rows, 70 states.
 * Link jansen.c with a program of your own,
 * or import the Python module built from jansen.pyx. */
#ifndef EM_MODEL_jansen_H
#define EM_MODEL_jansen_H

#include "eigenmotion.h"

extern const em_model jansen_model;

#endif
