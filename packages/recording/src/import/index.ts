export type { ImportOptions, ImportResult } from './import-writer.ts';
export { importCsv, previewCsv } from './csv/import-csv.ts';
export type { CsvColumn, CsvOptions, CsvPlan, CsvTopic, TimeUnit } from './csv/csv-plan.ts';
export {
  importXdf,
  previewXdf,
  type XdfImportOptions,
  type XdfPlan,
  type XdfTopic,
} from './xdf/import-xdf.ts';
