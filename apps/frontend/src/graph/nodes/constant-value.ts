import { DATA_FORMATS, fromJson, toJson, type DataFormat } from '@ubii/proto';
import { constantFormat } from '../model/ports.ts';

/** Formats a constant as users type it: `0.35`, `true`, a text, or JSON for other values. */
export function constantText(json: string): string {
  const format = constantFormat(json);
  if (format === undefined) return json;
  const value = (JSON.parse(json) as Record<string, unknown>)[format];
  return typeof value === 'object' ? JSON.stringify(value) : String(value);
}

/** Result of parsing a typed constant: its JSON, or the reason why it is invalid. */
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
    // Throws for values that the master refuses.
    fromJson('ubii.topicData.TopicDataRecord', { [format]: value });
    return { json: JSON.stringify({ [format]: value }) };
  } catch {
    return { problem: `This is not a valid ${format}. Example: ${exampleText(format)}` };
  }
}

/** Returns the initial value of a format. */
export function defaultConstant(format: DataFormat): string {
  const record = { [format]: DATA_FORMATS[format].createDefault() };
  const json = toJson('ubii.topicData.TopicDataRecord', record)[format];
  return JSON.stringify({ [format]: json ?? DATA_FORMATS[format].createDefault() });
}

const exampleText = (format: DataFormat): string => constantText(defaultConstant(format));
