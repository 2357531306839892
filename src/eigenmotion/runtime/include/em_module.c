/* em_module.c: the Python module of a model, whose `system` is its System: NAME.pyx, written in C.
 *
 * Compile it with -DEM_MODEL=NAME_model -DEM_INIT=PyInit_NAME, and link it with NAME.c. (The names are joined on the
 * command line, because NAME may be a macro here.) It is the same text for every model, and compiles in a tenth of a
 * second; translating NAME.pyx and compiling the result takes a second. */
#include <Python.h>

#include "eigenmotion.h"

extern const em_model EM_MODEL;

/* System(capsule, name of the module), or NULL with an exception set. */
static PyObject *em_system_of(PyObject *module) {
    PyObject *name = PyObject_GetAttrString(module, "__name__");
    PyObject *package = name ? PyImport_ImportModule("eigenmotion.system") : NULL;
    PyObject *capsule = package ? PyCapsule_New((void *)&EM_MODEL, "eigenmotion.em_model", NULL) : NULL;
    PyObject *system = capsule ? PyObject_CallMethod(package, "System", "OO", capsule, name) : NULL;
    Py_XDECREF(capsule);
    Py_XDECREF(package);
    Py_XDECREF(name);
    return system;
}

static int em_execute(PyObject *module) {
    PyObject *system = em_system_of(module);
    const int failed = system == NULL || PyModule_AddObjectRef(module, "system", system);
    Py_XDECREF(system);
    return failed ? -1 : 0;
}

static PyModuleDef_Slot em_slots[] = {{Py_mod_exec, (void *)em_execute}, {0, NULL}};

static struct PyModuleDef em_definition = {
    .m_base = PyModuleDef_HEAD_INIT,
    .m_name = "eigenmotion.model",
    .m_doc = "A compiled model: `system` is its System.",
    .m_slots = em_slots,
};

PyMODINIT_FUNC EM_INIT(void) { return PyModuleDef_Init(&em_definition); }
