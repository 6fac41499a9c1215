import { describe, expect, it } from 'vitest';
import type { TopicRate } from '../../connection/topic-rates.ts';
import { TopicsModel } from '../tree/topics-model.ts';
import { keyOutcome } from './tree-keys.ts';

const rateOf = (topic: string) =>
  ({ statistic: { topic, dataFormat: 'double', publisherId: '' } }) as TopicRate;

/** /a · /a/x · /a/y · /b */
function press(key: string, at: string, collapsed: readonly string[] = []) {
  const model = new TopicsModel(() => undefined);
  model.apply({ added: ['/a/x', '/a/y', '/b'].map(rateOf), removed: [] });
  for (const branch of collapsed) model.setExpanded(model.find(branch)!, false);
  model.refresh(0);
  const outcome = keyOutcome(key, {
    rows: model.rows,
    index: model.rows.findIndex((node) => node.key === at),
    isExpanded: (node) => model.isExpanded(node),
    pageSize: 2,
  });
  if (outcome === undefined) return undefined;
  const target = outcome.kind === 'focus' ? model.rows[outcome.index] : outcome.node;
  return `${outcome.kind} ${target?.key}`;
}

describe('keyOutcome', () => {
  it.each([
    ['ArrowDown', '/a', 'focus /a/x'],
    ['ArrowDown', '/b', 'focus /b'],
    ['ArrowUp', '/b', 'focus /a/y'],
    ['ArrowUp', '/a', 'focus /a'],
    ['PageDown', '/a', 'focus /a/y'],
    ['PageUp', '/b', 'focus /a/x'],
    ['Home', '/b', 'focus /a'],
    ['End', '/a', 'focus /b'],
    ['ArrowRight', '/a', 'focus /a/x'],
    ['ArrowRight', '/b', undefined],
    ['ArrowLeft', '/a', 'collapse /a'],
    ['ArrowLeft', '/a/y', 'focus /a'],
    ['ArrowLeft', '/b', undefined],
    ['*', '/a/x', 'expand-siblings /a/x'],
    ['Enter', '/a/x', 'select /a/x'],
    ['Enter', '/a', 'collapse /a'],
    [' ', '/b', 'select /b'],
    ['Tab', '/a', undefined],
  ])('%s at %s: %s', (key, at, outcome) => {
    expect(press(key, at)).toBe(outcome);
  });

  it('opens a closed branch before it goes into it', () => {
    expect(press('ArrowRight', '/a', ['/a'])).toBe('expand /a');
    expect(press('Enter', '/a', ['/a'])).toBe('expand /a');
    expect(press('ArrowLeft', '/a', ['/a'])).toBeUndefined();
  });
});
