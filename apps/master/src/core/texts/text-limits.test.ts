import { messageDescriptor, type MessageDescriptor } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { LIMITS } from '../limits/index.ts';
import { LISTED_TEXTS, TEXT_RULES } from './text-limits.ts';

/** Full names of all texts that may stand in these messages, and of messages that have a row as a whole. */
function textsIn(roots: readonly string[]): { names: Set<string>; lists: Set<string> } {
  const names = new Set<string>();
  const lists = new Set<string>();
  const known = new Set<MessageDescriptor>();
  const add = (message: MessageDescriptor): void => {
    if (known.has(message)) return;
    known.add(message);
    if (TEXT_RULES[message.name] !== undefined) {
      names.add(message.name);
      return;
    }
    for (const { type, protoName, repeated } of message.fields) {
      if (type === 'string') {
        names.add(`${message.name}.${protoName}`);
        if (repeated) lists.add(`${message.name}.${protoName}`);
      } else if (typeof type === 'object' && type.kind === 'message') add(type);
    }
  };
  for (const root of roots) add(messageDescriptor(root));
  return { names, lists };
}

const ROOTS = ['ubii.services.ServiceRequest', 'ubii.extension.NodeMessage'];

describe('the table of texts', () => {
  it('has a row for every text of a request and of what nodes say, and no other [EX-70]', () => {
    const { names } = textsIn(ROOTS);
    expect(Object.keys(TEXT_RULES).sort()).toEqual([...names].sort());
  });

  it('limits characters or bytes, or says why not [EX-70]', () => {
    for (const [name, rule] of Object.entries(TEXT_RULES)) {
      if ('limit' in rule) expect(LIMITS[rule.limit].unit, name).toMatch(/^(bytes|characters)$/);
      else expect(rule.unlimited, name).toMatch(/^[A-Z].*\.$/);
    }
  });

  it('limits lists of texts that have texts in them [EX-71]', () => {
    const { lists } = textsIn(ROOTS);
    for (const name of Object.keys(LISTED_TEXTS)) expect(lists).toContain(name);
  });
});
