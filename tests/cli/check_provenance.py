"""Is the provenance.json that a run writes the one of docs/provenance.schema.json?

    check_provenance.py RAMIFY SCHEMA

Makes a small run, checks what it wrote, and sees that the schema refuses near mistakes.
"""
import copy
import json
import pathlib
import subprocess
import sys
import tempfile

import jsonschema

CONFIG = """models     = ["bst", "ternary(0.2)"]
n          = [10, 2000]
replicates = 3
statistics = ["strahler"]
"""


def written_by_a_run(ramify):
    with tempfile.TemporaryDirectory() as folder:
        config = pathlib.Path(folder) / "small.toml"
        config.write_text(CONFIG)
        subprocess.run([ramify, "run", config, "--out", folder], check=True, capture_output=True)
        return json.loads((pathlib.Path(folder) / "small" / "provenance.json").read_text())


def near_mistakes(good):
    """(what is wrong, a provenance with that mistake), one after the other."""
    for key in good:
        yield f"no {key}", {k: v for k, v in good.items() if k != key}
    yield "an unknown key", good | {"user": "x"}
    for key, value in [("program", "rami"), ("version", "1"), ("seed", "1996"), ("seed", -1), ("threads", 0),
                       ("threads", 1.5), ("started", "yesterday"), ("duration_seconds", "1 s"), ("cells", 4),
                       ("status", "done"), ("sampled", []), ("config_text", None)]:
        yield f"{key} = {value!r}", good | {key: value}
    for key in good["sampled"][0]:
        wrong = copy.deepcopy(good)
        del wrong["sampled"][0][key]
        yield f"a cell without {key}", wrong
    wrong = copy.deepcopy(good)
    wrong["sampled"][-1]["seed"] = 1
    yield "a cell with an unknown key", wrong


def main(ramify, schema_file):
    schema = json.loads(pathlib.Path(schema_file).read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    good = written_by_a_run(ramify)
    failures = [error.message for error in validator.iter_errors(good)]
    validator.validate(good | {"status": "interrupted: only the cells listed are complete"})
    mistakes = 0
    for what, wrong in near_mistakes(good):
        mistakes += 1
        if validator.is_valid(wrong):
            failures.append(f"the schema lets pass: {what}")
    print(f"{len(good)} keys, {mistakes} near mistakes")
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
