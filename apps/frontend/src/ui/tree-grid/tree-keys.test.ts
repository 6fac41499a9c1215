import { describe, expect, it } from 'vitest';
import { treeKeyOutcome } from './tree-keys.ts';

/** a (expanded): a1, a2 (collapsed), a3; b */
const rows = ['a', 'a1', 'a2', 'a3', 'b'].map((key) => ({
  key,
  level: key.length,
  position: 1,
  setSize: 1,
}));
const EXPANDED: Readonly<Record<string, boolean>> = { a: true, a2: false };

function press(key: string, at: string): string | undefined {
  const index = rows.findIndex((row) => row.key === at);
  const isExpanded = (row: { readonly key: string }) => EXPANDED[row.key];
  const outcome = treeKeyOutcome(key, { rows, index, isExpanded, pageSize: 2 });
  return outcome?.kind === 'focus' ? rows[outcome.index]?.key : outcome?.kind;
}

describe('keys of a tree grid', () => {
  it.each([
    ['ArrowDown', 'a', 'a1'],
    ['ArrowDown', 'b', 'b'],
    ['ArrowUp', 'b', 'a3'],
    ['ArrowUp', 'a', 'a'],
    ['PageDown', 'a', 'a2'],
    ['PageDown', 'a3', 'b'],
    ['PageUp', 'b', 'a2'],
    ['Home', 'b', 'a'],
    ['End', 'a', 'b'],
    ['ArrowRight', 'a', 'a1'],
    ['ArrowRight', 'a2', 'expand'],
    ['ArrowRight', 'b', undefined],
    ['ArrowLeft', 'a', 'collapse'],
    ['ArrowLeft', 'a2', 'a'],
    ['ArrowLeft', 'a3', 'a'],
    ['ArrowLeft', 'b', undefined],
    ['*', 'a1', 'expand-siblings'],
    ['Enter', 'a1', 'open'],
    [' ', 'a', 'open'],
    ['Tab', 'a', undefined],
  ])('%s at %s: %s', (key, at, outcome) => {
    expect(press(key, at)).toBe(outcome);
  });

  it('mean nothing without rows', () => {
    const empty = { rows: [], index: 0, isExpanded: () => undefined, pageSize: 1 };
    expect(treeKeyOutcome('ArrowDown', empty)).toBeUndefined();
  });
});
