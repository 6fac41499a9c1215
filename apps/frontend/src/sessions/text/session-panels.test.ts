import type { Session } from '@ubii/proto';
import { expect, it } from 'vitest';
import { aSession } from '../testing/a-session.ts';
import { MAX_SESSION_PANELS, sessionPanels, withSessionPanels } from './session-panels.ts';

const session = (editorJson: string): Session => aSession({ json: { extension: { editorJson } } });
const layout = { type: 'ubi-interact-layout', version: 1, name: 'Arm' };
function saved(before: Session): Session {
  const change = withSessionPanels(before, layout);
  if (typeof change === 'string') throw new Error(change);
  return session(change.extension?.editorJson ?? '');
}

it('is saved beside the positions of nodes, and read again [EX-101]', () => {
  const before = session('{"format":"ubi-interact.graph","version":1,"nodes":{"a":{"x":1}}}');
  expect(sessionPanels(before)).toBeUndefined();
  const after = saved(before);
  expect(sessionPanels(after)).toEqual(layout);
  expect(JSON.parse(after.extension?.editorJson ?? '')).toMatchObject({ nodes: { a: { x: 1 } } });
  expect(sessionPanels(saved(after))).toEqual(layout);
});

it('is saved with a session that no editor has opened', () => {
  expect(sessionPanels(saved(session('')))).toEqual(layout);
});

it('leaves data of other programs alone, and refuses large layouts', () => {
  for (const text of ['{"format":"other","panels":1}', '{"panels"', '["panels"]']) {
    expect(withSessionPanels(session(text), layout)).toContain('another program');
    expect(sessionPanels(session(text))).toBeUndefined();
  }
  const large = { ...layout, name: 'x'.repeat(MAX_SESSION_PANELS) };
  expect(withSessionPanels(session(''), large)).toContain('too large');
});
