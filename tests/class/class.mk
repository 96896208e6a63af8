# How students hand in, and take in a newer version. Included by the Makefile.

ifneq ($(wildcard .update/switch),)
$(warning An update of this folder was interrupted. `make update` finishes it.)
endif

# Names from the command line reach the scripts through the environment: no quoting, whatever they hold.
WITH_FLAGS = submit class check-class class-trial
$(WITH_FLAGS) handout gradescope: export PHOTONLAB_BUILD = $(BUILD)
$(WITH_FLAGS): export PHOTONLAB_CC = $(CC)
$(WITH_FLAGS): export PHOTONLAB_FLAGS = $(STEP_FLAGS)
$(WITH_FLAGS): export PHOTONLAB_LINK = $(PLUGIN)

.PHONY: submit update

## submit          put your work into one archive, build/submit/: make submit [NAME=you] [FORCE=1]
submit: export PHOTONLAB_NAME = $(NAME)
submit: export PHOTONLAB_FORCE = $(FORCE)
submit:
	@bash tests/class/submit.sh

## update          take a newer photonlab into this folder; your work stays: make update FROM=photonlab-2.tar.gz
update: export PHOTONLAB_FROM = $(FROM)
update:
	@bash tests/class/update.sh

-include tests/class/teacher.mk
