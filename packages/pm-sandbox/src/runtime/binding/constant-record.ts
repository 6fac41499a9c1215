import {
  DATA_FORMATS,
  encode,
  fromJson,
  isDataFormat,
  recordOf,
  type DataFormat,
} from '@ubii/proto';
import { formatsFit } from './formats-fit.ts';

/** A constant as an input gets it, or why it is none. */
export type ConstantRecord =
  | { readonly bytes: Uint8Array; readonly valueField: number }
  | { readonly problem: string };

const RECORD_TYPE = 'ubii.topicData.TopicDataRecord';

/**
 * Encodes the constant of an input mapping. [PM-34]
 *
 * @param json text of one record member, such as `{"vector2":{"x":1,"y":0}}`
 * @param declared data format of the input, undefined when any is taken
 */
export function constantRecord(json: string, declared: DataFormat | undefined): ConstantRecord {
  let parsed: unknown;
  try {
    parsed = JSON.parse(json);
  } catch (error) {
    return { problem: `the constant is not JSON: ${messageOf(error)}` };
  }
  try {
    const message = fromJson(RECORD_TYPE, parsed);
    const { format } = recordOf(message);
    if (format === undefined || !isDataFormat(format)) {
      return { problem: 'the constant has no member of a data format, such as {"double":1}' };
    }
    if (!formatsFit(format, declared)) {
      return { problem: `the constant is ${format}, but the input expects ${declared}` };
    }
    const bytes = encode(RECORD_TYPE, { [format]: message[format] });
    return { bytes, valueField: DATA_FORMATS[format].fieldNumber };
  } catch (error) {
    return { problem: `the constant cannot be read: ${messageOf(error)}` };
  }
}

function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
