/* em_face.h: the common part of the functions of FMI 2.0 and 3.0, over the em_unit of the header that is included
 * before: em_unit.h, motion by forces, or em_inverse_unit.h, forces by motion.
 *
 * Before it are defined EM_FMU_MODEL, an em_model; EM_FMU_GUID, of modelDescription.xml; EM_FMU_OPTIONS, em_unit_options;
 * EM_FMU_TIME, the reference of the time; EM_FMU_FLOWS, whether there is model exchange; EM_FMU_OFFERS, why there is
 * none. Instances know nothing of each other. A version says in em_say how it logs. */
#ifndef EM_FACE_H
#define EM_FACE_H

#include <stdlib.h>
#include <string.h>

/* Of both versions, with the same numbers. */
enum { EM_OK, EM_DISCARD = 2, EM_ERROR };

typedef struct em_fmu {
    em_unit *unit;
    char *name;
    void *environment;
    void (*logger)(void); /* of the version's type, or NULL */
} em_fmu;

/* Tells the importing tool; returns the status. */
static int em_say(const em_fmu *fmu, int status, const char *words);

static int em_answer(const em_fmu *fmu, int failed) { return failed ? em_say(fmu, EM_ERROR, fmu->unit->words) : EM_OK; }

/* Of what a solver may try again, with a smaller step. */
static int em_try(const em_fmu *fmu, int failed) { return failed ? em_say(fmu, EM_DISCARD, fmu->unit->words) : EM_OK; }

static int em_none(const em_fmu *fmu, size_t count, const char *words) {
    return count == 0 ? EM_OK : em_say(fmu, EM_ERROR, words);
}

static void em_face_free(em_fmu *fmu) {
    if (fmu == NULL) return;
    if (fmu->unit != NULL) em_unit_free(fmu->unit);
    free(fmu->name);
    free(fmu);
}

/* NULL, with words for the log: no memory, or `offered` or the GUID is not that of this unit. */
static em_fmu *em_face_create(const char *name, const char *guid, int offered, void (*logger)(void), void *environment) {
    em_fmu *fmu = calloc(1, sizeof *fmu);
    if (fmu == NULL) return NULL;
    fmu->logger = logger;
    fmu->environment = environment;
    if ((fmu->name = malloc(strlen(name) + 1)) != NULL) strcpy(fmu->name, name);
    fmu->unit = em_unit_create(&EM_FMU_MODEL, EM_FMU_OPTIONS);
    const int known = offered && guid != NULL && strcmp(guid, EM_FMU_GUID) == 0;
    if (known && fmu->unit != NULL && fmu->name != NULL) return fmu;
    em_say(fmu, EM_ERROR, known ? "out of memory" : !offered ? EM_FMU_OFFERS : "the GUID of this unit is " EM_FMU_GUID);
    return em_face_free(fmu), NULL;
}

/* The instance of model exchange. */
static em_fmu *em_face_flow(em_fmu *fmu) {
    if (fmu != NULL) em_unit_let_flow(fmu->unit);
    return fmu;
}

static int em_face_begin(em_fmu *fmu, int has_tolerance, double tolerance, double start) {
    if (!isfinite(start) || (has_tolerance && !(tolerance > 0.0 && tolerance < 1.0)))
        return em_say(fmu, EM_ERROR, "the start is not finite, or the tolerance not between 0 and 1");
    em_unit_begin(fmu->unit, start, has_tolerance ? tolerance : 0.0);
    return EM_OK;
}

/* value (count) <- numbers by their references; those between two times are read at once */
static int em_face_get(em_fmu *fmu, const unsigned *reference, size_t count, double *value) {
    size_t done = 0;
    for (size_t k = 0; k <= count; ++k) {
        if (k < count && (long)reference[k] != EM_FMU_TIME) continue;
        if (em_unit_read(fmu->unit, reference + done, k - done, value + done)) return em_answer(fmu, 1);
        if (k < count) value[k] = em_unit_time(fmu->unit);
        done = k + 1;
    }
    return EM_OK;
}

static int em_face_set(em_fmu *fmu, const unsigned *reference, size_t count, const double *value) {
    for (size_t k = 0; k < count; ++k)
        if (em_unit_set(fmu->unit, reference[k], value[k])) return em_answer(fmu, 1);
    return EM_OK;
}

/* --- the state --- */

static int em_face_save(em_fmu *fmu, void **state) {
    if (*state == NULL) *state = calloc(1, em_unit_size(fmu->unit));
    if (*state == NULL) return em_say(fmu, EM_ERROR, "out of memory");
    em_unit_save(fmu->unit, *state);
    return EM_OK;
}

static int em_face_forget(void **state) {
    free(*state);
    *state = NULL;
    return EM_OK;
}

static int em_face_pack(em_fmu *fmu, const void *state, void *bytes, size_t size) {
    if (size < em_unit_size(fmu->unit)) return em_say(fmu, EM_ERROR, "a state is larger than that");
    memcpy(bytes, state, em_unit_size(fmu->unit));
    return EM_OK;
}

static int em_face_unpack(em_fmu *fmu, const void *bytes, size_t size, void **state) {
    if (size != em_unit_size(fmu->unit)) return em_say(fmu, EM_ERROR, "these bytes are no state of this unit");
    if (*state == NULL) *state = malloc(size);
    if (*state == NULL) return em_say(fmu, EM_ERROR, "out of memory");
    memcpy(*state, bytes, size);
    return EM_OK;
}

#endif
