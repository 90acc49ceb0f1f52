"""Writes flip.jsonl, a pair a line: what NVIDIA's own evaluator says of the pairs of flip-pictures.mjs.

Needs Node, Python 3 and `pip install flip-evaluator==1.7 numpy`; run it in this folder. The evaluator computes in float32;
only the mean of its map is taken here, in float64.

Of each pair the mean of the map, its largest value, and the values down its diagonal (row i * height / 8, column i * width / 8).
"""

import json
import pathlib
import subprocess
import tempfile

import flip_evaluator
import numpy

SAMPLES = 8

with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    subprocess.run(["node", "flip-pictures.mjs", name], check=True)
    vectors = []
    for i, pair in enumerate(json.loads((folder / "pairs.json").read_text())):
        shape = (pair["height"], pair["width"], 3)
        truth, picture = (
            numpy.fromfile(folder / f"{i}-{which}.f32", dtype=numpy.float32).reshape(shape)
            for which in ("truth", "picture")
        )
        error_map, _, _ = flip_evaluator.evaluate(truth, picture, "LDR", applyMagma=False)
        error_map = error_map.reshape(shape[:2])
        diagonal = [
            float(error_map[k * pair["height"] // SAMPLES, k * pair["width"] // SAMPLES]) for k in range(SAMPLES)
        ]
        vectors.append(
            {"name": pair["name"], "mean": float(error_map.mean(dtype=numpy.float64)), "max": float(error_map.max()), "diagonal": diagonal}
        )
    pathlib.Path("flip.jsonl").write_text("".join(json.dumps(vector) + "\n" for vector in vectors))
