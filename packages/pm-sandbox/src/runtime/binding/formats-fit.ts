import { DATA_FORMATS, dataFormatOfField, type DataFormat } from '@ubii/proto';

const NUMBER_FORMATS: ReadonlySet<DataFormat> = new Set(['double', 'float', 'int32']);

/**
 * Whether records of one data format can be taken where another is declared: the same, or both are
 * numbers. A format that is not known fits everything. [PM-3] [PM-31]
 */
export function formatsFit(
  format: DataFormat | undefined,
  declared: DataFormat | undefined,
): boolean {
  if (format === undefined || declared === undefined || format === declared) return true;
  return NUMBER_FORMATS.has(format) && NUMBER_FORMATS.has(declared);
}

/**
 * The same for records as they travel.
 *
 * @returns a function of the number of a record's value member, 0 for none, which fits no format
 */
export function fieldFits(declared: DataFormat | undefined): (valueField: number) => boolean {
  if (declared === undefined) return () => true;
  if (!NUMBER_FORMATS.has(declared)) {
    const { fieldNumber } = DATA_FORMATS[declared];
    return (valueField) => valueField === fieldNumber;
  }
  const fields = [...NUMBER_FORMATS].map((format) => DATA_FORMATS[format].fieldNumber);
  return (valueField) => fields.includes(valueField);
}

/** Describes the value of a record, for people. */
export function describeField(valueField: number): string {
  return valueField === 0 ? 'no value' : (dataFormatOfField(valueField) ?? `member ${valueField}`);
}
