import type { Client } from '@ubii/proto';

/**
 * One letter for each client, the same for all who see the same list: the first letter of its name
 * that no earlier client has, else of the alphabet; repeats when all are taken.
 */
export function clientLetters(clients: readonly Pick<Client, 'name'>[]): string[] {
  const taken = new Set<string>();
  return clients.map(({ name }) => {
    const own = [...name.toUpperCase()].filter((letter) => /\p{L}|\p{N}/u.test(letter));
    const letter =
      [...own, ...'ABCDEFGHIJKLMNOPQRSTUVWXYZ'].find((candidate) => !taken.has(candidate)) ??
      own[0] ??
      '?';
    taken.add(letter);
    return letter;
  });
}
