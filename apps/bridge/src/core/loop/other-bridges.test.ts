import { AccessRole } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { bridgeTag, OtherBridges } from './other-bridges.ts';

const { ACCESS_ROLE_ADMIN, ACCESS_ROLE_PARTICIPANT, ACCESS_ROLE_PLAYER } = AccessRole;

const tags = [bridgeTag('the broker')];

function createBridges() {
  const bridges = new OtherBridges('the broker');
  const add = (id: string, more: object = {}) =>
    bridges.handleClient({
      id,
      tags,
      isGone: false,
      isConnected: true,
      masterId: undefined,
      ...more,
    });
  const give = (role: AccessRole, ...ids: readonly string[]) =>
    bridges.handleRoles(ids.map((clientId) => ({ clientId, role })));
  return { bridges, add, give };
}

describe('bridges to the same system', () => {
  it('the one with the least id passes what several map alike, while it is connected [BR-24]', () => {
    const { bridges, add, give } = createBridges();
    for (const id of ['a', 'b', 'c']) add(id);
    give(ACCESS_ROLE_PARTICIPANT, 'a', 'b', 'c');
    bridges.handleMappings('a', 'lamps');
    bridges.handleMappings('b', 'lamps');
    bridges.handleMappings('c', 'doors');
    const passing = (id: string, mappings: string) => !bridges.passesFor(id, mappings);
    expect([passing('a', 'lamps'), passing('b', 'lamps'), passing('c', 'doors')]).toEqual([
      ...[true, false, true],
    ]);
    add('a', { isConnected: false });
    expect([passing('b', 'lamps'), bridges.has('a')]).toEqual([true, true]);
    add('a');
    expect(passing('b', 'lamps')).toBe(false);
    bridges.handleMappings('a', 'doors');
    expect([passing('b', 'lamps'), passing('c', 'doors')]).toEqual([true, false]);
    add('a', { isGone: true });
    expect([passing('c', 'doors'), bridges.has('a')]).toEqual([true, false]);
    add('b', { tags: ['bridge to elsewhere'] });
    expect(bridges.has('b')).toBe(false);
  });

  it('do not stand by for a bridge with fewer rights, or one that is unknown [BR-24]', () => {
    const { bridges, add, give } = createBridges();
    for (const id of ['a', 'b', 'c', 'd']) {
      add(id);
      bridges.handleMappings(id, 'lamps');
    }
    give(ACCESS_ROLE_PARTICIPANT, 'b');
    give(ACCESS_ROLE_PLAYER, 'a');
    give(ACCESS_ROLE_ADMIN, 'd');
    const passing = () => ['b', 'd'].filter((id) => !bridges.passesFor(id, 'lamps'));
    expect(passing()).toEqual(['d']);
    add('d', { isGone: true });
    expect(passing()).toContain('b');
  });

  it('are known when each has said what it passes, again after the master was lost', async () => {
    const { bridges, add, give } = createBridges();
    const changes: string[] = [];
    bridges.onChange(() => changes.push('change'));
    const known = bridges.untilKnown('own').then(() => changes.push('known'));
    add('other');
    add('own');
    bridges.handleMappings('other', 'lamps');
    bridges.handleMappings('other', 'lamps');
    give(ACCESS_ROLE_PARTICIPANT, 'own', 'other');
    await known;
    expect(changes).toEqual(['change', 'change', 'change', 'change', 'known']);
    bridges.handleLost();
    expect(bridges.passesFor('own', 'lamps')).toBe(false);
    const again = bridges.untilKnown('own');
    add('own');
    await again;
  });

  it('know the masters at which they are, also those that are lost [BR-21]', () => {
    const { bridges, add } = createBridges();
    add('a', { masterId: 'first' });
    add('a', { masterId: 'second' });
    add('a', { isGone: true });
    bridges.handleClient({
      id: 'x',
      tags: [],
      isGone: false,
      isConnected: true,
      masterId: 'third',
    });
    expect(['first', 'second', 'third', ''].map((id) => bridges.isMaster(id))).toEqual([
      ...[true, true, false, false],
    ]);
  });
});
