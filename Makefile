# What a newcomer runs: `make demo`, and `make quick` after a change. What CI runs: `make test`, `make check` and `make docs`; at night: `make nightly`.
# Needs python3, a C compiler and make.

PYTHON ?= python3
VENV   ?= .venv
BIN    := $(VENV)/bin
READY  := $(VENV)/.ready
RUNTIME := src/eigenmotion/runtime
COMPILED := $(addprefix src/eigenmotion/,runtime arguments compiled simulation)
MODELS := $(filter-out models/__init__.py,$(wildcard models/*.py))
# What a reader learns from stands in generated/: the paper's mechanism in every formulation, a linkage, a rolling body, a
# contact, a pendulum. Of all models it holds the sums
SHOWN_MODELS := $(patsubst %,models/%.py,bouncing_ball dual_link four_bar pendulum rolling_disk)
VARIANTS     := cholesky lagrange inverse
ALL          := build/generated
TYPES  := build/types/eigenmotion
DOCS   := $(VENV)/.docs
SCREENSHOTS := build/screenshots
# Robots of many joints take minutes to build for a page
LIVE   ?= $(filter-out humanoid quadruped,$(basename $(notdir $(MODELS))))
WORKED := docs/made/tutorial.done docs/made/index.done
SHOWN  := $(LIVE:%=docs/made/%.done)

# Of small matrices, as all are here, threads only wait for each other (tests/__init__.py says so to pytest, too)
quick test fuzz nightly docs check: export OPENBLAS_NUM_THREADS ?= 1

# SciPy's splines solve equations by BLAS, whose kernels round differently on each processor: sources are compared with one
generated regenerate generate-all: export OPENBLAS_CORETYPE := Haswell

.PHONY: demo quick test fuzz nightly docs screenshots check lint types generated regenerate bench clean
.DELETE_ON_ERROR:

demo: $(READY)
	$(BIN)/eigenmotion build models/dual_link.py -o build/demo
	$(BIN)/python -m eigenmotion.paper build/demo 2 3
	$(BIN)/eigenmotion run models/dual_link.py --t-end 10 --rtol 1e-9 --plot build/demo/dual_link.png
	$(BIN)/eigenmotion page models/dual_link.py -o build/demo/dual_link.html

# What compiles nothing (expressions, models, derivation, rules), the options of runs on a model written by hand, and one
# model in every formulation: for between two changes
QUICK := graph rules model/test_model.py equations/test_derive.py equations/test_specialise.py simulation/test_simulate.py accuracy/test_paper_scene.py

quick: $(READY)
	env -u PYTHONDONTWRITEBYTECODE $(BIN)/pytest -n auto $(addprefix tests/,$(QUICK)) $(PYTEST_ARGS)

# PYTEST_ARGS="-k name" runs a part. Bytecode is kept: pytest takes 6 seconds a process to rewrite assertions anew. Options
# of ours need "=": a folder by itself would be taken for the tests to run, and then the file that adds them is not read
test: $(READY)
	env -u PYTHONDONTWRITEBYTECODE $(BIN)/pytest -n auto --screenshots=$(SCREENSHOTS) $(PYTEST_ARGS)

# Random expressions and mechanisms by the thousand; FUZZ_ARGS="--trees 100 --mechanisms 3" takes fewer
fuzz: $(READY)
	$(BIN)/python -m tests.fuzz $(FUZZ_ARGS)

# Longer sweeps, and the suite with every compiler there is: one of ten parts a night, of the day's number; and of random
# cases one in ten, others in the next ten nights. `make nightly NIGHTS=1` takes all parts at once. What fails does not
# keep the rest from running
NIGHTS ?= 10
NIGHT  ?= $(shell date +%j)
SLICE  := --slice=$(NIGHT)/$(NIGHTS)
PEERS  := $(VENV)/.peers

nightly: $(READY) $(PEERS)
	if ! [ -x /usr/lib/wine/wine64 ] && [ "$$(id -u)" = 0 ] && command -v apt-get > /dev/null; then \
	    { apt-get update -qq && apt-get install -qq -y --no-install-recommends wine64 qemu-user; } > /dev/null 2>&1 || true; fi
	[ -x /usr/lib/wine/wine64 ] || command -v wine64 > /dev/null || echo "skipped: runs on Windows, for Wine is not here"
	failed=; $(BIN)/python -m tests.fuzz $(SLICE) $(FUZZ_ARGS) || failed=1; \
	for compiler in gcc clang; do \
	    command -v $$compiler > /dev/null || { echo "skipped: the suite with $$compiler, which is not here"; continue; }; \
	    EIGENMOTION_CFLAGS=-O1 CC=$$compiler $(BIN)/pytest -n auto $(SLICE) $$([ $$compiler = clang ] || echo '-m=') $(PYTEST_ARGS) || failed=1; \
	done; [ -z "$$failed" ]

# Other tools that compute the same: only the night's tests compare with them
$(PEERS): $(READY)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt 'eigenmotion[peers,oracles,torch]'
	touch $@

# The site, in build/site: every warning is an error. LIVE="pendulum four_bar" makes live pages of these models only
docs: $(DOCS) $(WORKED) $(SHOWN)
	$(BIN)/sphinx-build -q -W --keep-going -d build/doctrees docs build/site
	$(BIN)/python docs/making/links.py build/site
	$(BIN)/pytest -q tests/docs/test_site_looks.py --site=build/site --screenshots=$(SCREENSHOTS)
	@echo "the site: build/site/index.html"

# Photographs to look at of every page of the site, of each model's page, and of reports: 1400 and 400 pixels wide, light
# and dark; PYTEST_ARGS="-k four_bar" takes some. Their faults end it, as far as a program can detect them
screenshots: docs
	$(BIN)/pytest -q -m "" tests/docs/test_site_looks.py tests/export/test_page_looks.py --site=build/site \
	    --screenshots=$(SCREENSHOTS) $(PYTEST_ARGS)

# A page of the documentation, worked through: what its snippets draw is shown on it
$(WORKED): docs/made/%.done: docs/%.md docs/making/work.py docs/making/snippets.py $(wildcard src/eigenmotion/webpage/page/* src/eigenmotion/webpage/page/*/*) | $(READY)
	$(BIN)/python docs/making/work.py $*
	touch $@

# A model of the gallery: its picture, its live page, and what a run takes
$(SHOWN): docs/made/%.done: models/%.py docs/making/exhibit.py $(wildcard src/eigenmotion/webpage/page/* src/eigenmotion/webpage/page/*/*) | $(READY)
	$(BIN)/python docs/making/exhibit.py $*
	touch $@

# Side by side, and all that there is to say; who says --jobs says how many
check: $(READY)
	$(MAKE) --no-print-directory $(if $(filter -j%,$(MAKEFLAGS)),,--jobs=2) --keep-going lint types generated

lint: $(READY)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

# mypy does not follow the package mapping of pyproject.toml: lay the package out with links. Nothing runs the benchmarks:
# that they call what there is, with the arguments it takes, is checked here, and no more of their types
UNCHECKED := arg-type assignment dict-item index misc no-any-return no-untyped-call no-untyped-def return-value type-arg \
    union-attr unused-ignore var-annotated
types: $(READY)
	rm -rf $(TYPES)
	mkdir -p $(TYPES)
	ln -s $(CURDIR)/src/eigenmotion/* $(CURDIR)/codegen $(CURDIR)/models $(CURDIR)/templates $(TYPES)
	$(BIN)/mypy
	MYPYPATH=build/types:benchmarks $(BIN)/mypy --cache-dir=.mypy_cache/benchmarks --explicit-package-bases \
	    $(UNCHECKED:%=--disable-error-code=%) benchmarks/*.py

# The models' sources are those that were committed: of a few the text, of all the sums
generated: $(READY) generate-all
	cd $(ALL) && sha256sum --check --quiet --strict $(CURDIR)/generated/sums.txt
	! grep -n '.\{121,\}' $(ALL)/*.[ch]
	$(BIN)/eigenmotion generate --check --strict --diff $(SHOWN_MODELS)
	for name in $(VARIANTS); do \
	    $(BIN)/eigenmotion generate --check --strict --diff --formulation $$name -o generated/$$name models/dual_link.py || exit 1; \
	done

regenerate: $(READY) generate-all
	cd $(ALL) && LC_ALL=C sha256sum *.c *.h *.pyx > $(CURDIR)/generated/sums.txt
	$(BIN)/eigenmotion generate $(SHOWN_MODELS)
	for name in $(VARIANTS); do \
	    $(BIN)/eigenmotion generate --formulation $$name -o generated/$$name models/dual_link.py || exit 1; \
	done

.PHONY: generate-all
generate-all: $(READY)
	rm -rf $(ALL)
	$(BIN)/eigenmotion generate -o $(ALL) $(MODELS) > /dev/null

bench: $(READY)
	for script in benchmarks/*.py; do echo "== $$script"; $(BIN)/python "$$script" || exit 1; done

clean:
	rm -rf $(VENV) build dist docs/made docs/gallery .pytest_cache .mypy_cache .ruff_cache .hypothesis src/*.egg-info
	rm -f generated/*.so $(foreach ending,c d so,$(COMPILED:=/*.$(ending)))
	find . -name __pycache__ -prune -exec rm -rf {} +

# The environment, remade when what it is made from changes; where that is a source or a header of an extension module (setup.py has
# the compiler list these), only modules that it is part of
MADE_FROM := pyproject.toml setup.py constraints.txt
INSTALL   := -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[dev,plot,page,xarray,cluster,fmu,casadi,gym,robots,jax]'
-include $(wildcard $(COMPILED:=/*.d))
$(READY): $(MADE_FROM) $(wildcard $(COMPILED:=/*.pyx) $(COMPILED:=/*.pxd))
	test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	for module in $(COMPILED:=/*.so); do [ -e "$${module%%.*}.pyx" ] || rm -f "$$module"; done # of modules that are no more
	$(BIN)/python $(if $(filter $(MADE_FROM),$?),$(INSTALL),setup.py --quiet build_ext --inplace)
	$(BIN)/python -m compileall -q src codegen # where PYTHONDONTWRITEBYTECODE is set nothing else would keep it
	env -u PYTHONDONTWRITEBYTECODE $(BIN)/python -c "from eigenmotion.codegen.render import emit; emit.compile_templates()"
	touch $@

# What the site is made with, of no use to anybody else
$(DOCS): $(READY)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt 'eigenmotion[docs]'
	touch $@
