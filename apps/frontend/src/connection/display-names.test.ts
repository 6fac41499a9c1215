import { describe, expect, it } from 'vitest';
import { displayNames, isClientId, type NamedClient } from './display-names.ts';

const client = (id: string, name: string, isPresent = true): NamedClient => ({
  id,
  name,
  isPresent,
});
const shown = (clients: readonly NamedClient[], before?: ReadonlyMap<string, string>) => [
  ...displayNames(clients, before).entries(),
];

describe('displayNames()', () => {
  it('numbers clients of the same name in their order', () => {
    expect(shown([client('a', 'Phone'), client('b', 'Phone'), client('c', 'Desk')])).toEqual([
      ['a', 'Phone'],
      ['b', 'Phone 2'],
      ['c', 'Desk'],
    ]);
  });

  it('gives no client a number that is the name of another client', () => {
    const names = displayNames([
      client('a', 'Phone'),
      client('b', 'Phone'),
      client('c', 'Phone 2'),
    ]);
    expect(names.get('c')).toBe('Phone 2');
    expect(names.get('b')).toBe('Phone 3');
  });

  it('keeps the display name of a client while the others come and go', () => {
    const before = displayNames([client('a', 'Phone'), client('b', 'Phone')]);
    const after = displayNames([client('b', 'Phone'), client('c', 'Phone')], before);
    expect(after.get('b')).toBe('Phone 2');
    expect(after.get('c')).toBe('Phone');
  });

  it('follows a client that is renamed', () => {
    const before = displayNames([client('a', 'Phone'), client('b', 'Phone')]);
    expect(displayNames([client('a', 'Phone'), client('b', 'Ada')], before).get('b')).toBe('Ada');
  });

  it('prefers clients that are here to clients that are gone', () => {
    const before = displayNames([client('a', 'Phone')]);
    const after = displayNames([client('a', 'Phone', false), client('b', 'Phone')], before);
    expect(after.get('b')).toBe('Phone');
    expect(after.get('a')).toBe('Phone 2');
  });

  it('names a client without a name by the beginning of its id', () => {
    expect(shown([client('9b2f9c1e-3f0a-4d6e', '')])).toEqual([
      ['9b2f9c1e-3f0a-4d6e', 'Client 9b2f9c1e'],
    ]);
  });
});

it('an id of a client is a UUID', () => {
  expect(isClientId('9b2f9c1e-3f0a-4d6e-8a11-0c1d2e3f4a5b')).toBe(true);
  expect(isClientId('9b2f9c1e')).toBe(false);
  expect(isClientId('robot')).toBe(false);
});
