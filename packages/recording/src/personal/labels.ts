import { compileGlob } from '@ubii/patterns';
import {
  messageDescriptor,
  PersonalTreatment,
  type FieldDescriptor,
  type PersonalLabel,
} from '@ubii/proto';
import { isMessage, type Fields } from './treat-message.ts';

const RECORD = messageDescriptor('ubii.topicData.TopicDataRecord');

/** Data formats: members of a record of which one is set. */
export const VALUE_FIELDS: readonly FieldDescriptor[] = RECORD.fields.filter(
  ({ oneof }) => oneof !== undefined,
);

const TREATMENTS = new Set<PersonalTreatment>(Object.values(PersonalTreatment));

/** A label that can be applied to records. */
export interface ReadyLabel {
  readonly matches: (topic: string) => boolean;
  /** Members down to the value; none: the whole record. */
  readonly path: readonly FieldDescriptor[];
  readonly treatment: PersonalTreatment;
  /** Unit of rounding, above 0. */
  readonly step: number;
  /** The whole topic is dropped. */
  readonly dropsTopic: boolean;
}

/** Makes a label ready. One whose members or treatment this program does not know drops its topics. */
export function readyLabel(label: PersonalLabel): ReadyLabel {
  const { topicPattern, fieldPath, treatment, step } = label;
  const path = parseFieldPath(fieldPath);
  const isKnown = path !== undefined && TREATMENTS.has(treatment);
  const dropsAll = fieldPath === '' && treatment === PersonalTreatment.PERSONAL_TREATMENT_DROP;
  return {
    matches: compileGlob(topicPattern),
    path: path ?? [],
    treatment,
    step: step > 0 && Number.isFinite(step) ? step : 1,
    dropsTopic: !isKnown || dropsAll,
  };
}

/** Parses a path such as `object2DList.elements.id`; undefined when the schema has no such member. */
export function parseFieldPath(text: string): readonly FieldDescriptor[] | undefined {
  if (text === '') return [];
  const path: FieldDescriptor[] = [];
  let fields = VALUE_FIELDS;
  for (const name of text.split('.')) {
    const field = fields.find(({ jsonName }) => jsonName === name);
    if (field === undefined) return undefined;
    path.push(field);
    fields = isMessage(field.type) ? field.type.fields : [];
  }
  return path;
}

/**
 * Applies a label to a decoded record.
 *
 * @param pseudonym of a text; its prefix names the kind of value
 * @returns false when the record has to be dropped
 */
export function applyLabel(
  record: Fields,
  { path, treatment, step }: ReadyLabel,
  pseudonym: (text: string, prefix: string) => string,
): boolean {
  const change = (field: FieldDescriptor, value: unknown): unknown =>
    treatment === PersonalTreatment.PERSONAL_TREATMENT_PSEUDONYM
      ? typeof value === 'string' && field.type === 'string'
        ? pseudonym(value, prefixOf(field))
        : value
      : roundedValue(field, value, step);
  const target = targetOf(record, path);
  if (target === undefined) return true;
  for (const owner of ownersOf(record, path)) {
    if (owner[target.jsonName] === undefined) continue;
    if (isTreated(target, treatment)) changeBelow(owner, target, change);
    else if (path.length <= 1) return false;
    else owner[target.jsonName] = emptyOf(target);
  }
  return true;
}

/**
 * Visits the texts of a decoded record that a label drops or replaces.
 *
 * @param visit is called with the prefix of the pseudonym; with undefined for a text that is dropped
 */
export function eachLabelledText(
  record: Fields,
  { path, treatment, dropsTopic }: ReadyLabel,
  visit: (text: string, prefix: string | undefined) => void,
): void {
  const target = targetOf(record, path);
  if (target === undefined) return;
  const isDropped = dropsTopic || !isTreated(target, treatment);
  if (!isDropped && treatment === PersonalTreatment.PERSONAL_TREATMENT_ROUND) return;
  for (const owner of ownersOf(record, path)) {
    eachTextBelow(owner, target, (text, field) =>
      visit(text, isDropped ? undefined : prefixOf(field)),
    );
  }
}

/** The member that a label names in a record; without a path, its value. */
function targetOf(record: Fields, path: ReadyLabel['path']): FieldDescriptor | undefined {
  return path.at(-1) ?? VALUE_FIELDS.find(({ jsonName }) => record[jsonName] !== undefined);
}

/** The messages that have the last member of a path. */
function ownersOf(record: Fields, path: ReadyLabel['path']): readonly Fields[] {
  let owners: readonly Fields[] = [record];
  for (const { jsonName } of path.slice(0, -1)) {
    owners = owners.flatMap((owner) => listOf(owner[jsonName]) as Fields[]);
  }
  return owners;
}

function eachTextBelow(
  owner: Fields,
  field: FieldDescriptor,
  visit: (text: string, field: FieldDescriptor) => void,
): void {
  for (const value of listOf(owner[field.jsonName])) {
    if (typeof value === 'string') visit(value, field);
    else if (isMessage(field.type)) {
      for (const inner of field.type.fields) eachTextBelow(value as Fields, inner, visit);
    }
  }
}

/** Whether a member is changed; if not, it is dropped. */
function isTreated(field: FieldDescriptor, treatment: PersonalTreatment): boolean {
  return treatment !== PersonalTreatment.PERSONAL_TREATMENT_DROP && isTreatable(field, treatment);
}

/** Whether a treatment changes anything in a member; if not, the member is dropped. */
export function isTreatable({ type }: FieldDescriptor, treatment: PersonalTreatment): boolean {
  if (treatment === PersonalTreatment.PERSONAL_TREATMENT_DROP) return true;
  if (isMessage(type)) return type.fields.some((field) => isTreatable(field, treatment));
  if (treatment === PersonalTreatment.PERSONAL_TREATMENT_PSEUDONYM) return type === 'string';
  return isNumber(type);
}

/** Changes a member and all below it. Bytes, which cannot be judged, are emptied. */
function changeBelow(
  owner: Fields,
  field: FieldDescriptor,
  change: (field: FieldDescriptor, value: unknown) => unknown,
): void {
  const { jsonName, type } = field;
  const value = owner[jsonName];
  if (value === undefined) return;
  if (type === 'bytes') owner[jsonName] = emptyOf(field);
  else if (isMessage(type)) {
    for (const each of listOf(value)) {
      for (const inner of type.fields) changeBelow(each as Fields, inner, change);
    }
  } else {
    owner[jsonName] = Array.isArray(value)
      ? value.map((each) => change(field, each))
      : change(field, value);
  }
}

function roundedValue({ type }: FieldDescriptor, value: unknown, step: number): unknown {
  if (!isNumber(type) || typeof value !== 'number' || !Number.isFinite(value)) return value;
  // Multiples of 0.1 are written as people write them.
  const rounded = Number((Math.round(value / step) * step).toPrecision(12));
  return type === 'int32' || type === 'int64' ? Math.round(rounded) : rounded;
}

function isNumber(type: FieldDescriptor['type']): boolean {
  return type === 'double' || type === 'float' || type === 'int32' || type === 'int64';
}

function emptyOf({ repeated, type }: FieldDescriptor): unknown {
  if (repeated) return [];
  if (isMessage(type)) return undefined;
  if (type === 'string') return '';
  if (type === 'bytes') return new Uint8Array();
  return type === 'bool' ? false : 0;
}

function listOf(value: unknown): readonly unknown[] {
  if (value === undefined) return [];
  return Array.isArray(value) ? value : [value];
}

/** `display-name` of `displayName`. */
function prefixOf({ jsonName }: FieldDescriptor): string {
  return jsonName.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
}
