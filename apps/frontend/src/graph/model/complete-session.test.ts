import type { ProcessingModule } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { aSession } from '../../sessions/testing/a-session.ts';
import { completeSession, missingWords, withPlaceholders } from './complete-session.ts';
import { graphOf } from './graph-of.ts';

const [module] = aSession().processingModules as [ProcessingModule];
let count = 0;
const uuid = (): string => `uuid-${(count += 1)}`;
/** Session of a file that only names its modules. */
const named = () => aSession({ json: { processingModules: [{ id: 'module', name: 'mirror' }] } });

describe('completeSession', () => {
  it('puts in what the library has, below what the session says [SE-1]', () => {
    const session = completeSession(named(), [{ ...module, id: '', description: 'Mirrors.' }]);
    expect(session.processingModules[0]).toMatchObject({
      id: 'module',
      description: 'Mirrors.',
      onProcessingStringified: '() => ({})',
    });
    expect(session.processingModules[0]?.inputs).toHaveLength(3);
  });

  it('leaves alone what has its code', () => {
    const session = aSession();
    const other = { ...module, onProcessingStringified: '() => 1' };
    expect(completeSession(session, [other])).toBe(session);
  });
});

describe('withPlaceholders', () => {
  it('keeps unknown modules completely, with their wires', () => {
    const { session, missing } = withPlaceholders(named(), [], uuid);
    expect(missing).toEqual(['mirror']);
    expect(session.processingModules).toEqual([]);
    const graph = graphOf(session);
    const node = graph.nodes.get('module:module');
    expect(node).toMatchObject({ kind: 'module', standing: 'muted' });
    expect(graph.wires.size).toBe(2);
  });

  it('reports nothing when the modules are known, or the code is in the file', () => {
    expect(withPlaceholders(named(), [module], uuid).missing).toEqual([]);
    const session = aSession();
    expect(withPlaceholders(session, [], uuid)).toEqual({ session, missing: [] });
  });

  it('says it in one sentence', () => {
    expect(missingWords([])).toBe('');
    expect(missingWords(['pose'])).toContain('The module pose is unknown.');
    expect(missingWords(['pose', 'hand'])).toContain('2 modules are unknown: pose, hand.');
  });
});
