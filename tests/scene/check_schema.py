"""Validates scene files against the schema: check_schema.py SCHEMA FOLDER. Files named good*.json must pass, bad*.json must not. Exit code 77: no jsonschema."""

import json
import pathlib
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)

schema = json.loads(pathlib.Path(sys.argv[1]).read_text())
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
wrong = 0
for file in sorted(pathlib.Path(sys.argv[2]).iterdir()):
    errors = list(validator.iter_errors(json.loads(file.read_text())))
    if bool(errors) == file.name.startswith("good"):
        wrong += 1
        print(file.name, [error.message for error in errors][:3] or "is accepted", file.read_text()[:300])
print(wrong, "wrong")
sys.exit(1 if wrong else 0)
