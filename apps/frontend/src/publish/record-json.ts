import {
  DATA_FORMATS,
  findJsonProblems,
  fromJson,
  isDataFormat,
  messageDescriptor,
  type DataFormat,
  type DataFormatValues,
  type FieldDescriptor,
  type JsonObject,
  type JsonProblem,
} from '@ubii/proto';
import { defaultJson } from '../message-form/default-json.ts';
import { fillIn, type VariableSource } from './variables.ts';

const RECORD = 'ubii.topicData.TopicDataRecord';
/** Members that the client library fills in. */
const NOT_TYPED = new Set(['timestamp', 'clientId', 'client_id', 'extension']);

/** A record in the form that the client publishes. */
export interface OutgoingRecord {
  readonly topic: string;
  readonly format: DataFormat;
  readonly value: DataFormatValues[DataFormat];
}

/** The member of a record that carries a data format. */
export function recordField(format: DataFormat): FieldDescriptor {
  return messageDescriptor(RECORD).fieldByName.get(format)!;
}

/** The data format of a record written as JSON. */
export function formatOfJson(json: JsonObject): DataFormat | undefined {
  return Object.keys(json).find((key): key is DataFormat => isDataFormat(key));
}

export function topicOfJson({ topic }: JsonObject): string {
  return typeof topic === 'string' ? topic : '';
}

/** A record with the default value of its data format. */
export function newRecord(topic: string, format: DataFormat): JsonObject {
  return { topic, [format]: defaultJson(recordField(format).type) };
}

/** Returns the problems because of which a record cannot be published. */
export function checkRecord(json: JsonObject, source: VariableSource): JsonProblem[] {
  const filled = fillIn(json, source) as JsonObject;
  const problems = findJsonProblems(RECORD, filled);
  const topic = topicOfJson(filled);
  if (filled.topic !== undefined && typeof filled.topic !== 'string') {
    if (!problems.some(({ path }) => path === 'topic'))
      problems.push({ path: 'topic', sentence: 'must be a text in double quotes' });
  } else if (topic === '') {
    problems.push({ path: 'topic', sentence: 'must not be empty. Example: /lab/light.' });
  }
  for (const key of Object.keys(json)) {
    if (NOT_TYPED.has(key))
      problems.push({ path: key, sentence: 'is set automatically. Remove it.' });
  }
  const format = formatOfJson(json);
  if (format === undefined) {
    problems.push({
      path: '',
      sentence: 'The record has no value. Add one, for example "double": 0.5.',
    });
  } else if (problems.length === 0) {
    // Validation that needs the whole value, such as the bytes of an image.
    const sentence = DATA_FORMATS[format].validate(valueOf(filled, format));
    if (sentence !== undefined) problems.push(placed(sentence));
  }
  return problems;
}

/** Returns a record without problems, ready to be published. */
export function readRecord(json: JsonObject, source: VariableSource): OutgoingRecord {
  const filled = fillIn(json, source) as JsonObject;
  const format = formatOfJson(filled)!;
  return { topic: topicOfJson(filled), format, value: valueOf(filled, format) };
}

function valueOf(json: JsonObject, format: DataFormat): DataFormatValues[DataFormat] {
  return fromJson(RECORD, json)[format] as DataFormatValues[DataFormat];
}

/** Splits `image2D.data must be …` into path and sentence. */
function placed(sentence: string): JsonProblem {
  const [path = '', ...rest] = sentence.split(' ');
  return { path, sentence: rest.join(' ') };
}
