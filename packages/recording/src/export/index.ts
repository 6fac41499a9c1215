export {
  flattenValue,
  topicTable,
  type Cell,
  type TableColumn,
  type TableOptions,
  type TableRow,
  type TopicTable,
} from './topic-table.ts';
export { csvOf } from './csv.ts';
export { writeParquet } from './parquet.ts';
export { xdfOf, type XdfOptions } from './xdf/xdf.ts';
