import { PersonalTreatment, type PersonalLabel } from '@ubii/proto';
import { isTreatable, parseFieldPath, VALUE_FIELDS } from '@ubii/recording/personal';

type Member = (typeof VALUE_FIELDS)[number];

/** What can be done with a value, by the name that a select knows. */
export const TREATMENTS = [
  { value: 'pseudonym', text: 'Pseudonym' },
  { value: 'round', text: 'Round' },
  { value: 'drop', text: 'Drop' },
] as const;

export type TreatmentName = (typeof TREATMENTS)[number]['value'];

const BY_NAME: Readonly<Record<TreatmentName, PersonalTreatment>> = {
  pseudonym: PersonalTreatment.PERSONAL_TREATMENT_PSEUDONYM,
  round: PersonalTreatment.PERSONAL_TREATMENT_ROUND,
  drop: PersonalTreatment.PERSONAL_TREATMENT_DROP,
};

export const treatmentOf = (name: TreatmentName): PersonalTreatment => BY_NAME[name];

export function nameOfTreatment(treatment: PersonalTreatment): TreatmentName {
  return TREATMENTS.find(({ value }) => BY_NAME[value] === treatment)?.value ?? 'drop';
}

/** Members that a select offers at most. */
const MAX_MEMBERS = 200;

/** The members of values of some data formats, for a select. The first stands for the whole value. */
export function memberOptions(formats: ReadonlySet<string>) {
  const options = [{ value: ' ', text: 'Whole value' }];
  const add = (member: Member, before: string): void => {
    if (options.length > MAX_MEMBERS) return;
    const path = before === '' ? member.jsonName : `${before}.${member.jsonName}`;
    options.push({ value: path, text: memberText(path) });
    const { type } = member;
    if (typeof type !== 'object' || type.kind !== 'message') return;
    for (const inner of type.fields) add(inner, path);
  };
  for (const field of VALUE_FIELDS) if (formats.has(field.jsonName)) add(field, '');
  return options;
}

/** A path for people: lists have no part of their own. */
export function memberText(path: string): string {
  return path === ''
    ? 'Whole value'
    : path
        .split('.')
        .filter((part) => part !== 'elements')
        .join(' › ');
}

/** Treatments that change something in a member. */
export function treatmentsFor(path: string) {
  const member = parseFieldPath(path)?.at(-1);
  return TREATMENTS.filter(
    ({ value }) => member === undefined || isTreatable(member, BY_NAME[value]),
  );
}

/** An example of a value before and after. */
export function exampleOf(path: string, name: TreatmentName, step: number): [string, string] {
  const last = path.split('.').at(-1) ?? '';
  if (name === 'pseudonym') return ['Ada', `${last === '' ? 'string' : last}-7f3a9c`];
  if (name === 'drop') return [path === '' ? 'all records' : '71.64', 'left out'];
  const unit = step > 0 ? step : 1;
  return ['71.64', String(Number((Math.round(71.64 / unit) * unit).toPrecision(12)))];
}

/** A label in a row. */
export function labelText({ fieldPath, treatment, step }: PersonalLabel): string {
  const name = nameOfTreatment(treatment);
  const done = name === 'round' ? `round to ${step || 1}` : name === 'drop' ? 'drop' : 'pseudonym';
  return `${memberText(fieldPath)}: ${done}`;
}
