import type { Figure } from '../measure/findings.ts';
import type { TestResult } from '../results/test-result.ts';

/** Figure of a run, compared with the first run. */
export interface ComparedCell {
  readonly figure: Figure;
  /** Change relative to the first run, percent; `undefined` in the first run, and when its figure is 0. */
  readonly changePercent: number | undefined;
  /** Direction of the change, if it exceeds random variation. */
  readonly change: 'better' | 'worse' | undefined;
}

export interface ComparedRow {
  readonly key: string;
  readonly label: string;
  /** One cell per run; `undefined` where it was not measured. */
  readonly cells: readonly (ComparedCell | undefined)[];
}

/** Random variation between runs of a test on one computer, percent. */
const CHANCE_PERCENT = 10;

/** Returns one row per figure, with cells in the order of the runs. */
export function compareFigures(runs: readonly TestResult[]): ComparedRow[] {
  const rows = new Map<string, string>();
  for (const { findings } of runs) {
    for (const { key, label } of findings.figures) if (!rows.has(key)) rows.set(key, label);
  }
  const figureOf = ({ findings }: TestResult, key: string): Figure | undefined =>
    findings.figures.find((one) => one.key === key);
  return [...rows].map(([key, label]) => {
    const first = runs[0] && figureOf(runs[0], key);
    const cells = runs.map((run, index) => {
      const figure = figureOf(run, key);
      return figure && compared(figure, index === 0 ? undefined : first);
    });
    return { key, label, cells };
  });
}

function compared(figure: Figure, first: Figure | undefined): ComparedCell {
  if (first === undefined || first.value === 0) {
    return { figure, changePercent: undefined, change: undefined };
  }
  const changePercent = ((figure.value - first.value) / Math.abs(first.value)) * 100;
  const isMore = changePercent > 0;
  const isChance = figure.better === undefined || Math.abs(changePercent) < CHANCE_PERCENT;
  return {
    figure,
    changePercent,
    change: isChance ? undefined : isMore === (figure.better === 'more') ? 'better' : 'worse',
  };
}

/** Parameter or circumstance of several runs. */
export interface ComparedFact {
  readonly key: string;
  readonly label: string;
  readonly values: readonly string[];
  /** True when the runs differ, which may explain different figures. */
  readonly differs: boolean;
}

const NO_FACT = '–';

/** Returns parameters, then circumstances; differing ones first. */
export function compareFacts(runs: readonly TestResult[]): ComparedFact[] {
  const factsOf = ({ parameters, circumstances }: TestResult) => [
    ...parameters.map(({ key, label, value, unit }) => ({
      key: `parameter ${key}`,
      label,
      value: unit ? `${value} ${unit}` : `${value}`,
    })),
    ...circumstances.map(({ key, label, value }) => ({ key: `around ${key}`, label, value })),
  ];
  const labels = new Map(
    runs.flatMap((run) => factsOf(run).map(({ key, label }) => [key, label] as const)),
  );
  const facts = [...labels].map(([key, label]) => {
    const values = runs.map((run) => factsOf(run).find((one) => one.key === key)?.value ?? NO_FACT);
    return { key, label, values, differs: new Set(values).size > 1 };
  });
  return [...facts.filter(({ differs }) => differs), ...facts.filter(({ differs }) => !differs)];
}
