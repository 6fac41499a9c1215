import * as v from 'valibot';
import { finite, textUpTo } from '../../json/schemas.ts';
import { TEST_KINDS } from '../measure/findings.ts';
import type { TestResult } from './test-result.ts';

/** Limits for lists and texts of valid results. */
const MAX_LIST = 10_000;
const MAX_TEXT_CHARS = 2_000;
const MAX_DECIMALS = 6;

const text = textUpTo(MAX_TEXT_CHARS);
const listOf = <S extends v.GenericSchema>(item: S) => v.pipe(v.array(item), v.maxLength(MAX_LIST));

const FIGURE = v.object({
  key: text,
  label: text,
  value: finite,
  unit: text,
  decimals: v.optional(
    v.pipe(
      finite,
      v.transform((count) => Math.min(MAX_DECIMALS, Math.max(0, Math.round(count)))),
    ),
  ),
  better: v.optional(v.picklist(['less', 'more'])),
});

const HISTOGRAM = v.object({ key: text, title: text, firstBin: finite, counts: listOf(finite) });

const CURVE = v.object({
  key: text,
  title: text,
  x: v.object({ label: text, unit: text, values: listOf(finite) }),
  y: v.object({ label: text, unit: text }),
  lines: listOf(v.object({ key: text, label: text, values: listOf(v.nullable(finite)) })),
  mark: v.optional(v.object({ x: finite, text })),
  isLogarithmic: v.optional(v.boolean()),
});

/** Schema of results in files and storage; unknown members are dropped. */
export const RESULT: v.GenericSchema<unknown, TestResult> = v.object({
  id: text,
  kind: v.picklist(TEST_KINDS),
  name: text,
  startedMs: finite,
  durationMs: finite,
  ended: v.picklist(['complete', 'stopped', 'disconnected']),
  parameters: listOf(
    v.object({ key: text, label: text, value: v.union([text, finite]), unit: v.optional(text) }),
  ),
  circumstances: listOf(v.object({ key: text, label: text, value: text })),
  findings: v.object({
    figures: listOf(FIGURE),
    histograms: listOf(HISTOGRAM),
    curves: listOf(CURVE),
    notes: listOf(text),
  }),
});
