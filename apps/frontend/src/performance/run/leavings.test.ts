// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import { createLeavings, removalRequest } from './leavings.ts';

describe('what a run leaves', () => {
  beforeEach(() => sessionStorage.clear());

  it('is known after a reload, until it is gone', () => {
    const before = createLeavings(sessionStorage);
    before.add({ kind: 'client', id: 'c' });
    before.add({ kind: 'session', id: 's' });
    before.drop({ kind: 'client', id: 'c' });
    expect(createLeavings(sessionStorage).all).toEqual([{ kind: 'session', id: 's' }]);
  });

  it('is nothing when the storage holds something else', () => {
    for (const text of ['{', '{}', '[1, {"kind":"house","id":"x"}]']) {
      sessionStorage.setItem('ubii.performance.leavings', text);
      expect(createLeavings(sessionStorage).all).toEqual([]);
    }
  });

  it('is taken away by one request', () => {
    expect(removalRequest({ kind: 'session', id: 's' })).toMatchObject({
      topic: '/services/session/runtime/remove',
      session: { id: 's' },
    });
    expect(removalRequest({ kind: 'client', id: 'c' })).toMatchObject({
      topic: '/services/client/deregistration',
      client: { id: 'c' },
    });
  });
});
