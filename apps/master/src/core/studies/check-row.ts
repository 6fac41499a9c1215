import {
  StudyCheckKind,
  StudyCheckState,
  type StudyCheckItem,
  type StudyCheckRow,
  type StudyDevice,
} from '@ubii/proto';

/** What the master knows of a device that fits a required one; `undefined`: unknown. */
export interface DeviceFacts {
  readonly name: string;
  /** Records per second of its fastest topic. */
  readonly rateHz: number | undefined;
  /** Charge, 0 to 1. */
  readonly battery: number | undefined;
  readonly clockErrorMs: number | undefined;
}

/** Most names in a row. */
const MAX_NAMES = 20;
const { STUDY_CHECK_STATE_OK: OK, STUDY_CHECK_STATE_MISSING: MISSING } = StudyCheckState;
const LOW = StudyCheckState.STUDY_CHECK_STATE_LOW;

/** A requirement besides that a device is there. */
interface Requirement {
  readonly kind: StudyCheckKind;
  readonly isRequired: boolean;
  valueOf(facts: DeviceFacts): number | undefined;
  isMet(value: number): boolean;
  /** Whether the first value is the worse one. */
  isWorse(a: number, b: number): boolean;
  format(value: number): string;
  readonly unknown: string;
}

/** Compares a required device with those that fit it. [ST-30] */
export function checkRow(device: StudyDevice, found: readonly DeviceFacts[]): StudyCheckRow {
  const requirements = requirementsOf(device).filter(({ isRequired }) => isRequired);
  const failures = (facts: DeviceFacts): number =>
    requirements.filter((each) => stateOf(each, facts) !== OK).length;
  const best = [...found].sort((a, b) => failures(a) - failures(b)).slice(0, device.count);
  const items = [
    presence(device, found.length),
    ...(best.length === 0 ? [] : requirements.map((each) => itemOf(each, best))),
  ];
  return {
    name: device.name,
    state: worst(items.map(({ state }) => state)),
    items,
    found: found.slice(0, MAX_NAMES).map(({ name }) => name),
  };
}

/** Names of the values in a sentence. */
const NOUNS: Readonly<Record<StudyCheckKind, string>> = {
  [StudyCheckKind.STUDY_CHECK_KIND_PRESENCE]: '',
  [StudyCheckKind.STUDY_CHECK_KIND_RATE]: 'rate ',
  [StudyCheckKind.STUDY_CHECK_KIND_BATTERY]: 'battery ',
  [StudyCheckKind.STUDY_CHECK_KIND_CLOCK]: 'clock error ',
};

/** What is wrong with rows, in one line; empty when nothing is. */
export function troublesOf(rows: readonly StudyCheckRow[]): string {
  return rows
    .filter(({ state }) => state !== OK)
    .map(({ name, items }) => {
      const texts = items
        .filter(({ state }) => state !== OK)
        .map(({ kind, text }) => `${NOUNS[kind]}${text}`);
      return `${name}: ${texts.join(', ')}`;
    })
    .join('; ');
}

function requirementsOf({ minRateHz, minBattery, maxClockErrorMs }: StudyDevice): Requirement[] {
  return [
    {
      kind: StudyCheckKind.STUDY_CHECK_KIND_RATE,
      isRequired: minRateHz > 0,
      valueOf: ({ rateHz }) => rateHz,
      isMet: (value) => value >= minRateHz,
      isWorse: (a, b) => a < b,
      format: (value) => `${rounded(value)} Hz (at least ${rounded(minRateHz)} Hz)`,
      unknown: 'not known',
    },
    {
      kind: StudyCheckKind.STUDY_CHECK_KIND_BATTERY,
      isRequired: minBattery > 0,
      valueOf: ({ battery }) => battery,
      isMet: (value) => value >= minBattery,
      isWorse: (a, b) => a < b,
      format: (value) => `${percent(value)} (at least ${percent(minBattery)})`,
      unknown: 'not reported',
    },
    {
      kind: StudyCheckKind.STUDY_CHECK_KIND_CLOCK,
      isRequired: maxClockErrorMs > 0,
      valueOf: ({ clockErrorMs }) => clockErrorMs,
      isMet: (value) => value <= maxClockErrorMs,
      isWorse: (a, b) => a > b,
      format: (value) => `${rounded(value)} ms (at most ${rounded(maxClockErrorMs)} ms)`,
      unknown: 'not reported',
    },
  ];
}

function presence({ count }: StudyDevice, found: number): StudyCheckItem {
  return {
    kind: StudyCheckKind.STUDY_CHECK_KIND_PRESENCE,
    state: found >= count ? OK : MISSING,
    text: `${found} of ${count} found`,
  };
}

/** The worst of these devices. */
function itemOf(requirement: Requirement, devices: readonly DeviceFacts[]): StudyCheckItem {
  const { kind, unknown, format, isWorse } = requirement;
  const values = devices.map((facts) => requirement.valueOf(facts));
  const known = values.filter((value) => value !== undefined);
  if (known.length < values.length) return { kind, state: MISSING, text: unknown };
  const value = known.reduce((a, b) => (isWorse(b, a) ? b : a));
  return { kind, state: requirement.isMet(value) ? OK : LOW, text: format(value) };
}

function stateOf({ valueOf, isMet }: Requirement, facts: DeviceFacts): StudyCheckState {
  const value = valueOf(facts);
  if (value === undefined) return MISSING;
  return isMet(value) ? OK : LOW;
}

function worst(states: readonly StudyCheckState[]): StudyCheckState {
  if (states.includes(MISSING)) return MISSING;
  return states.includes(LOW) ? LOW : OK;
}

/** Two digits below 10, so that a rate below its minimum does not look the same; whole numbers stay whole. */
function rounded(value: number): string {
  return String(value < 10 ? Math.floor(value * 100) / 100 : Math.floor(value));
}

function percent(value: number): string {
  return `${Math.floor(value * 100)} %`;
}
