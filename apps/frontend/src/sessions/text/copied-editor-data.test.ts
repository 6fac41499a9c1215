import { describe, expect, it } from 'vitest';
import { applyCommand } from '../../graph/model/commands/apply-command.ts';
import type { GraphCommand } from '../../graph/model/commands/graph-command.ts';
import { graphOf } from '../../graph/model/graph-of.ts';
import { sessionOf } from '../../graph/model/session-of.ts';
import { aSession } from '../testing/a-session.ts';
import { sessionCopy, sessionSpec } from './session-spec.ts';

let count = 0;
const uuid = (): string => `0000-${(count += 1)}`;
const changed = (...commands: readonly GraphCommand[]) => {
  const base = aSession();
  const all = { kind: 'all', label: '', commands } as const;
  return sessionOf(applyCommand(graphOf(base), all).graph, base);
};
const copyOf = (session: ReturnType<typeof changed>) => {
  const copy = sessionCopy(sessionSpec(session), uuid);
  return graphOf({ ...aSession(), ...copy } as ReturnType<typeof aSession>);
};

describe('a copy of a session', () => {
  it('lies as the original does', () => {
    const positions = new Map([['module:module', { x: 320, y: 80 }]]);
    const copy = copyOf(changed({ kind: 'move', positions }));
    const [node] = [...copy.nodes.values()].filter(({ kind }) => kind === 'module');
    expect(node?.id).not.toBe('module:module');
    expect(node?.position).toEqual({ x: 320, y: 80 });
  });

  it('keeps what is set aside, under an id of its own', () => {
    const standing = { kind: 'setStanding', nodes: ['module:module'], standing: 'muted' } as const;
    const copy = copyOf(changed(standing));
    const [node] = [...copy.nodes.values()].filter(({ kind }) => kind === 'module');
    expect(node).toMatchObject({ standing: 'muted' });
    expect(node?.id).not.toBe('module:module');
    expect(copy.wires.size).toBe(2);
  });

  it('keeps editor data of others as it is', () => {
    const session = aSession({ json: { extension: { editorJson: 'not JSON' } } });
    expect(sessionCopy(sessionSpec(session), uuid).extension?.editorJson).toBe('not JSON');
  });
});
