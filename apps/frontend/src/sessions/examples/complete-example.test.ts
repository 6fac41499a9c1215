import { EXAMPLE_SESSIONS, moduleLibrary } from '@ubii/modules';
import type { Init, Session } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { mappedModule } from '../words/mapping-words.ts';
import { completeExample } from './complete-example.ts';

describe('completeExample', () => {
  it.each(Object.entries<Init<Session>>(EXAMPLE_SESSIONS))(
    'shows of %s what a master would make of it [SE-1, SE-2]',
    (_name, spec) => {
      const session = completeExample(spec, moduleLibrary());
      const ids = session.processingModules.map(({ id }) => id);
      expect(new Set(ids).size).toBe(ids.length);
      for (const module of session.processingModules) {
        const { inputs, outputs } = mappedModule(module, session);
        expect([...inputs, ...outputs].every(({ isDeclared }) => isDeclared)).toBe(true);
        expect(outputs.length).toBeGreaterThan(0);
      }
    },
  );
});
