import { expect, it } from 'vitest';
import { diagnosticsText, type DiagnosticFacts } from './diagnostics.ts';

const FACTS = {
  nowMs: 0,
  page: { version: '1.2.3', path: '/topics', userAgent: 'Test', theme: 'dark' },
  connection: {
    state: { status: 'connected', clientId: 'secret-id', resumeToken: 'secret-token' },
    roundTrip: { lastMs: 3, p50Ms: 3, p95Ms: 5 },
    counters: { recordsIn: 1 },
  },
  status: {
    version: '0.1.0',
    masterId: 'm',
    startedMs: 0,
    nowMs: 5000,
    problems: [{ code: 'master_busy', text: 'It is busy.', remedy: 'Do less.', sinceMs: 1000 }],
    events: [],
    samples: [],
  },
  settings: { runtime: 'Node.js', elements: [{ flag: '--port', value: '8080', given: false }] },
  limits: [
    { name: 'topics', value: 10, unit: 'topics', hits: 0, use: { value: 9 } },
    { name: 'clients', value: 10, unit: 'clients', hits: 0, use: { value: 0 } },
  ],
  sessions: [
    { name: 'S', processingModules: [{ onProcessingStringified: 'secret code' }], status: 0 },
  ],
  log: [{ number: 1, timeMs: 0, level: 1, message: 'a warning', fields: [] }],
} as unknown as DiagnosticFacts;

it('one JSON text with versions, settings, problems and log', () => {
  const report = JSON.parse(diagnosticsText(FACTS)) as Record<string, unknown>;
  expect(report).toMatchObject({
    made: '1970-01-01T00:00:00.000Z',
    page: { version: '1.2.3', path: '/topics' },
    master: { version: '0.1.0', upSeconds: 5, problems: [{ code: 'master_busy' }] },
    startedWith: { flags: [{ flag: '--port', value: '8080' }] },
    limits: [{ name: 'topics', used: 9, state: 'near' }],
    sessions: [{ name: 'S', modules: 1 }],
    log: ['1970-01-01T00:00:00.000Z WARN  a warning'],
  });
});

it('no tokens, no ids of this page, no code', () => {
  expect(diagnosticsText(FACTS)).not.toContain('secret');
});

it('what could not be had is left out', () => {
  const text = diagnosticsText({
    ...FACTS,
    status: undefined,
    settings: undefined,
    limits: undefined,
    sessions: undefined,
    log: undefined,
  });
  expect(Object.keys(JSON.parse(text) as object)).toEqual(['made', 'page', 'connection']);
});
