import { DATA_FORMATS, fromJson, toJson, type DataFormat } from '@ubii/proto';
import { constantFormat } from '../model/ports.ts';

/** A constant as people type it: `0.35`, `true`, a text, or JSON for all else. */
export function constantText(json: string): string {
  const format = constantFormat(json);
  if (format === undefined) return json;
  const value = (JSON.parse(json) as Record<string, unknown>)[format];
  return typeof value === 'object' ? JSON.stringify(value) : String(value);
}

/** What came of a typed constant: its JSON, or what is wrong with it. */
export type TypedConstant =
  | { readonly json: string; readonly problem?: undefined }
  | { readonly json?: undefined; readonly problem: string };

const NUMBERS: ReadonlySet<DataFormat> = new Set(['double', 'float', 'int32']);

/** Parses typed text as a value of a format. [PM-34] */
export function typedConstant(format: DataFormat, text: string): TypedConstant {
  const trimmed = text.trim();
  if (format === 'string') return constantOf(format, text);
  if (NUMBERS.has(format)) {
    const value = Number(trimmed.replace('−', '-').replace(',', '.'));
    if (trimmed === '' || !Number.isFinite(value))
      return { problem: `Enter a number, such as 0.5.` };
    return constantOf(format, value);
  }
  if (format === 'bool') {
    if (trimmed !== 'true' && trimmed !== 'false') return { problem: 'Enter true or false.' };
    return constantOf(format, trimmed === 'true');
  }
  try {
    return constantOf(format, JSON.parse(trimmed));
  } catch {
    return { problem: `Enter the ${format} as JSON, such as ${exampleText(format)}.` };
  }
}

function constantOf(format: DataFormat, value: unknown): TypedConstant {
  try {
    // Refuses what the master would refuse.
    fromJson('ubii.topicData.TopicDataRecord', { [format]: value });
    return { json: JSON.stringify({ [format]: value }) };
  } catch {
    return { problem: `This is not a valid ${format}. Example: ${exampleText(format)}` };
  }
}

/** A value of a format to begin with. */
export function defaultConstant(format: DataFormat): string {
  const record = { [format]: DATA_FORMATS[format].createDefault() };
  const json = toJson('ubii.topicData.TopicDataRecord', record)[format];
  return JSON.stringify({ [format]: json ?? DATA_FORMATS[format].createDefault() });
}

const exampleText = (format: DataFormat): string => constantText(defaultConstant(format));
