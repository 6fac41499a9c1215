import assert from 'node:assert/strict';
import { test } from 'node:test';

import { stepsTogether } from './steps.mjs';

/** Steps that note when they begin, and end when they are told. */
function controlledSteps(names) {
  const begun = [];
  const ends = new Map();
  const steps = names.map((name) => ({
    name,
    work: () => {
      begun.push(name);
      return new Promise((resolve, reject) => ends.set(name, { resolve, reject }));
    },
  }));
  return { begun, ends, steps };
}

const nextTurn = () => new Promise((resolve) => setImmediate(resolve));

test('two steps run at once, and the next begins when one of them ends', async () => {
  const { begun, ends, steps } = controlledSteps(['long', 'short', 'last']);
  const all = stepsTogether(steps);
  assert.deepEqual(begun, ['long', 'short']);
  ends.get('short').resolve();
  await nextTurn();
  assert.deepEqual(begun, ['long', 'short', 'last']);
  ends.get('long').resolve();
  ends.get('last').resolve();
  await all;
});

test('after a step that fails none begins, and the one that runs is waited for', async () => {
  const { begun, ends, steps } = controlledSteps(['long', 'broken', 'never']);
  let settled = false;
  const all = stepsTogether(steps).finally(() => (settled = true));
  const rejected = assert.rejects(all, /wrong/);
  ends.get('broken').reject(new Error('wrong'));
  await nextTurn();
  assert.equal(settled, false);
  ends.get('long').resolve();
  await rejected;
  assert.deepEqual(begun, ['long', 'broken']);
});
