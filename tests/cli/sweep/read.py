# Reads a dataset by what is installed and compares it with its CSV: read.py sweep.parquet sweep.csv
import csv
import json
import sys

parquet, table = sys.argv[1:]


def by_polars():
    import polars

    return polars.read_parquet(parquet).rows(), polars.read_parquet_metadata(parquet)


def by_duckdb():
    import duckdb

    pairs = duckdb.sql(f"select key, value from parquet_kv_metadata('{parquet}')").fetchall()
    rows = duckdb.sql(f"select * from '{parquet}'").fetchall()
    return rows, {key.decode(): value.decode() for key, value in pairs}


def same(cell, text):
    return text == "" if cell is None else type(cell)(text) == cell


with open(table, newline="") as file:
    header, *wanted = csv.reader(file)
read = []
for reader in (by_polars, by_duckdb):
    try:
        rows, about = reader()
    except ImportError:
        continue
    assert len(rows) == len(wanted) > 0, (len(rows), len(wanted))
    for row, texts in zip(rows, wanted):
        assert len(row) == len(texts) and all(map(same, row, texts)), (row, texts)
    columns = {column["name"]: column for column in json.loads(about["columns"])}
    assert list(columns) == header, columns
    assert columns["max_rotation"]["unit"] == "rad" and 'name = "skew45-abutment"' in about["scene"], about
    read.append(reader.__name__)
print(" and ".join(read) if read else "nothing")
