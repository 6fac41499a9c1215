import {
  TEST_KINDS,
  type Curve,
  type Figure,
  type Findings,
  type Histogram,
} from '../measure/findings.ts';
import type { Circumstance, Parameter, TestEnd, TestResult } from './test-result.ts';

/** Longer lists and texts are no result of ours. */
const MAX_LIST = 10_000;
const MAX_TEXT = 2_000;
const ENDS: readonly TestEnd[] = ['complete', 'stopped', 'disconnected'];

/** Why a file is not what it should be: one sentence that names the place. */
export class ResultFormatError extends Error {
  constructor(place: string, expected: string) {
    super(`${place} should be ${expected}.`);
    this.name = 'ResultFormatError';
  }
}

/**
 * Takes a result from a file or the store as it should be; what is not known is left out.
 * @throws ResultFormatError
 */
export function readResult(value: unknown, place: string): TestResult {
  const from = record(value, place);
  const at = (name: string): string => `${place}.${name}`;
  return {
    id: text(from.id, at('id')),
    kind: oneOf(from.kind, TEST_KINDS, at('kind')),
    name: text(from.name, at('name')),
    startedMs: number(from.startedMs, at('startedMs')),
    durationMs: number(from.durationMs, at('durationMs')),
    ended: oneOf(from.ended, ENDS, at('ended')),
    parameters: list(from.parameters, at('parameters'), readParameter),
    circumstances: list(from.circumstances, at('circumstances'), readCircumstance),
    findings: readFindings(from.findings, at('findings')),
  };
}

function readParameter(value: unknown, place: string): Parameter {
  const from = record(value, place);
  return {
    key: text(from.key, `${place}.key`),
    label: text(from.label, `${place}.label`),
    value:
      typeof from.value === 'string'
        ? text(from.value, `${place}.value`)
        : number(from.value, `${place}.value`),
    ...(from.unit === undefined ? {} : { unit: text(from.unit, `${place}.unit`) }),
  };
}

function readCircumstance(value: unknown, place: string): Circumstance {
  const from = record(value, place);
  return {
    key: text(from.key, `${place}.key`),
    label: text(from.label, `${place}.label`),
    value: text(from.value, `${place}.value`),
  };
}

function readFindings(value: unknown, place: string): Findings {
  const from = record(value, place);
  return {
    figures: list(from.figures, `${place}.figures`, readFigure),
    histograms: list(from.histograms, `${place}.histograms`, readHistogram),
    curves: list(from.curves, `${place}.curves`, readCurve),
    notes: list(from.notes, `${place}.notes`, text),
  };
}

function readFigure(value: unknown, place: string): Figure {
  const from = record(value, place);
  const { better, decimals } = from;
  return {
    key: text(from.key, `${place}.key`),
    label: text(from.label, `${place}.label`),
    value: number(from.value, `${place}.value`),
    unit: text(from.unit, `${place}.unit`),
    ...(decimals === undefined
      ? {}
      : { decimals: Math.min(6, Math.max(0, Math.round(number(decimals, `${place}.decimals`)))) }),
    ...(better === undefined
      ? {}
      : { better: oneOf(better, ['less', 'more'] as const, `${place}.better`) }),
  };
}

function readHistogram(value: unknown, place: string): Histogram {
  const from = record(value, place);
  return {
    key: text(from.key, `${place}.key`),
    title: text(from.title, `${place}.title`),
    firstBin: number(from.firstBin, `${place}.firstBin`),
    counts: list(from.counts, `${place}.counts`, number),
  };
}

function readCurve(value: unknown, place: string): Curve {
  const from = record(value, place);
  const x = record(from.x, `${place}.x`);
  const y = record(from.y, `${place}.y`);
  const mark = from.mark === undefined ? undefined : record(from.mark, `${place}.mark`);
  return {
    key: text(from.key, `${place}.key`),
    title: text(from.title, `${place}.title`),
    x: {
      label: text(x.label, `${place}.x.label`),
      unit: text(x.unit, `${place}.x.unit`),
      values: list(x.values, `${place}.x.values`, number),
    },
    y: { label: text(y.label, `${place}.y.label`), unit: text(y.unit, `${place}.y.unit`) },
    lines: list(from.lines, `${place}.lines`, (line, at) => {
      const one = record(line, at);
      return {
        key: text(one.key, `${at}.key`),
        label: text(one.label, `${at}.label`),
        values: list(one.values, `${at}.values`, (item, where) =>
          item === null ? null : number(item, where),
        ),
      };
    }),
    ...(mark === undefined
      ? {}
      : { mark: { x: number(mark.x, `${place}.mark.x`), text: text(mark.text, `${place}.mark`) } }),
    ...(from.isLogarithmic === true ? { isLogarithmic: true } : {}),
  };
}

type Members = Readonly<Record<string, unknown>>;

function record(value: unknown, place: string): Members {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as Members;
  throw new ResultFormatError(place, 'an object');
}

function text(value: unknown, place: string): string {
  if (typeof value === 'string' && value.length <= MAX_TEXT) return value;
  throw new ResultFormatError(place, `a text of up to ${MAX_TEXT} characters`);
}

function number(value: unknown, place: string): number {
  if (typeof value === 'number' && Number.isFinite(value)) return value;
  throw new ResultFormatError(place, 'a number');
}

function oneOf<const T extends string>(value: unknown, all: readonly T[], place: string): T {
  const found = all.find((one) => one === value);
  if (found !== undefined) return found;
  throw new ResultFormatError(place, all.map((one) => `"${one}"`).join(' or '));
}

function list<T>(
  value: unknown,
  place: string,
  read: (item: unknown, place: string) => T,
): readonly T[] {
  if (!Array.isArray(value) || value.length > MAX_LIST) {
    throw new ResultFormatError(place, `a list of up to ${MAX_LIST} elements`);
  }
  return value.map((item, index) => read(item, `${place}[${index}]`));
}
