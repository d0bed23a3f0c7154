//! The dataset as Parquet: the columns of the CSV with their types, and what the sweep is in the file's own metadata.

use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{Type, TypePtr};
use serde_json::Value;

use super::dataset::{Column, Dataset, columns};
use super::row::Row;

/// Rows of a row group: what readers hold at once, 2²⁰ as is usual.
const GROUP: usize = 1 << 20;

impl Dataset<'_> {
    /// As Parquet, uncompressed but for dictionaries. The metadata has the parts of `about` by their names: `scene`,
    /// `girderbench`, `columns` with their units, and so on.
    ///
    /// # Errors
    ///
    /// Those of the writer.
    pub fn parquet(&self, about: &Value) -> Result<Vec<u8>, ParquetError> {
        let columns = columns(self.plan);
        let fields = columns.iter().map(field).collect::<Result<_, _>>()?;
        let schema = Type::group_type_builder("sweep").with_fields(fields).build()?;
        let properties = WriterProperties::builder()
            .set_created_by(concat!("girderbench ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_key_value_metadata(Some(metadata(about)))
            .build();
        let mut writer = SerializedFileWriter::new(Vec::new(), Arc::new(schema), Arc::new(properties))?;
        let rows: Vec<&Row> = self.rows.values().collect();
        for rows in rows.chunks(GROUP) {
            let mut group = writer.next_row_group()?;
            for column in &columns {
                let Some(mut out) = group.next_column()? else { break };
                self.write(column, rows, &mut out)?;
                out.close()?;
            }
            group.close()?;
        }
        writer.into_inner()
    }

    fn write(
        &self,
        column: &Column<'_>,
        rows: &[&Row],
        out: &mut SerializedColumnWriter<'_>,
    ) -> Result<(), ParquetError> {
        let written = match column {
            Column::Run => {
                let numbers: Vec<i64> = rows.iter().map(|row| row.run.try_into().unwrap_or(i64::MAX)).collect();
                out.typed::<Int64Type>().write_batch(&numbers, None, None)
            }
            Column::Key(place, axis) => {
                let value = |row: &&Row| self.plan.choice(row.run)[*place];
                if let Some(numbers) = axis.numbers() {
                    let numbers: Vec<f64> = rows.iter().map(|row| numbers[value(row)]).collect();
                    out.typed::<DoubleType>().write_batch(&numbers, None, None)
                } else {
                    let texts: Vec<ByteArray> =
                        rows.iter().map(|row| axis.values[value(row)].as_str().into()).collect();
                    out.typed::<ByteArrayType>().write_batch(&texts, None, None)
                }
            }
            Column::Measure(place, _) => {
                let values: Vec<f64> = rows.iter().filter_map(|row| row.values[*place]).collect();
                let there: Vec<i16> = rows.iter().map(|row| row.values[*place].is_some().into()).collect();
                out.typed::<DoubleType>().write_batch(&values, Some(&there), None)
            }
            Column::Status => {
                let words: Vec<ByteArray> = rows.iter().map(|row| row.status.word().into()).collect();
                out.typed::<ByteArrayType>().write_batch(&words, None, None)
            }
            Column::Reason => {
                let given = |row: &&&Row| !row.reason.is_empty();
                let texts: Vec<ByteArray> = rows.iter().filter(given).map(|row| row.reason.as_str().into()).collect();
                let there: Vec<i16> = rows.iter().map(|row| given(&row).into()).collect();
                out.typed::<ByteArrayType>().write_batch(&texts, Some(&there), None)
            }
        };
        written.map(drop)
    }
}

/// The parts of `sweep.json`, text as it is and everything else as JSON.
fn metadata(about: &Value) -> Vec<KeyValue> {
    let text = |value: &Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    let parts = about.as_object().into_iter().flatten();
    parts.map(|(name, value)| KeyValue::new(name.clone(), text(value))).collect()
}

/// Name and type of a column.
fn field(column: &Column<'_>) -> Result<TypePtr, ParquetError> {
    let number = if column.is_number() { Physical::DOUBLE } else { Physical::BYTE_ARRAY };
    let (physical, repetition) = match column {
        Column::Run => (Physical::INT64, Repetition::REQUIRED),
        Column::Key(..) | Column::Status => (number, Repetition::REQUIRED),
        Column::Measure(..) | Column::Reason => (number, Repetition::OPTIONAL),
    };
    let text = (physical == Physical::BYTE_ARRAY).then_some(LogicalType::String);
    let field =
        Type::primitive_type_builder(column.name(), physical).with_repetition(repetition).with_logical_type(text);
    Ok(Arc::new(field.build()?))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use parquet::file::reader::{FileReader as _, SerializedFileReader};
    use parquet::record::Field;

    use super::*;
    use crate::scene::presets;
    use crate::study::sweep::{Plan, Status, about};

    #[test]
    fn every_cell_and_the_scene_come_back() {
        let texts = |texts: &[&str]| texts.iter().map(|text| (*text).to_owned()).collect::<Vec<_>>();
        let vary = texts(&["motion.angle_deg=0..90:2", "contact.law=paper,return-mapping"]);
        let scene = presets::load("skew45-abutment").expect("ships");
        let plan = Plan::new(scene, &vary, &texts(&["max_rotation"]), Box::new(|_| Ok(()))).expect("a plan");
        let row = |run, value: Option<f64>, reason: &str| {
            let status = if reason.is_empty() { Status::Complete } else { Status::GaveUp };
            (run, Row { run, status, values: vec![value], reason: reason.to_owned() })
        };
        let rows = [row(0, Some(0.1 + 0.2), ""), row(1, None, "at 1 s"), row(2, None, ""), row(3, Some(0.0), "")];
        let rows = BTreeMap::from(rows);
        let bytes = Dataset { plan: &plan, rows: &rows }.parquet(&about(&plan)).expect("written");
        let mut file = tempfile::tempfile().expect("a file");
        std::io::Write::write_all(&mut file, &bytes).expect("written");
        let reader = SerializedFileReader::new(file).expect("Parquet");
        let read: Vec<Vec<(String, Field)>> = reader
            .get_row_iter(None)
            .expect("rows")
            .map(|row| row.expect("a row").get_column_iter().map(|(name, cell)| (name.clone(), cell.clone())).collect())
            .collect();
        let cell =
            |row: usize, column: &str| read[row].iter().find(|(name, _)| name == column).expect("there").1.clone();
        let text = |text: &str| Field::Str(text.to_owned());
        assert_eq!(read.len(), 4, "a row a run");
        assert_eq!([cell(0, "run"), cell(3, "run")], [Field::Long(0), Field::Long(3)], "in order");
        assert_eq!(
            [cell(0, "motion.angle_deg"), cell(3, "motion.angle_deg")],
            [Field::Double(0.0), Field::Double(90.0)],
            "as numbers"
        );
        assert_eq!(
            [cell(0, "contact.law"), cell(3, "contact.law")],
            [text("paper"), text("return-mapping")],
            "as words"
        );
        assert_eq!(
            [cell(0, "max_rotation"), cell(1, "max_rotation")],
            [Field::Double(0.1 + 0.2), Field::Null],
            "values"
        );
        assert_eq!([cell(1, "status"), cell(1, "reason")], [text("gave up"), text("at 1 s")], "how it ended");
        assert_eq!(cell(2, "reason"), Field::Null, "no reason");
        let metadata = reader.metadata().file_metadata().key_value_metadata().expect("metadata").clone();
        let part = |name: &str| metadata.iter().find(|part| part.key == name).and_then(|part| part.value.clone());
        assert_eq!(part("scene"), Some(plan.scene_text()), "the scene");
        assert_eq!(part("girderbench").as_deref(), Some(env!("CARGO_PKG_VERSION")), "the version");
        assert!(part("columns").is_some_and(|columns| columns.contains("\"unit\":\"rad\"")), "units");
    }
}
