import {
  clientConnectionSuite,
  clockSuite,
  documentStoreSuite,
  idSourceSuite,
  logSuite,
  patternCompilerSuite,
  resourceUsageSuite,
  resumeTokensSuite,
} from './acceptance/index.ts';
import {
  FakeClock,
  FixedUsage,
  MemoryDocuments,
  NativePatterns,
  PlainTokens,
  RecordingConnection,
  RecordingLog,
  SequentialIds,
} from './index.ts';

clockSuite('FakeClock', () => {
  const clock = new FakeClock();
  return { clock, passTime: () => clock.advance(100) };
});

idSourceSuite('SequentialIds', () => new SequentialIds());

resumeTokensSuite('PlainTokens', () => new PlainTokens());

patternCompilerSuite('NativePatterns', () => new NativePatterns());

resourceUsageSuite('FixedUsage', () => new FixedUsage());

logSuite('RecordingLog', () => {
  const log = new RecordingLog();
  return { log, lines: () => log.lines };
});

clientConnectionSuite('RecordingConnection', () => {
  const connection = new RecordingConnection();
  return {
    connection,
    next: async () => connection.sent.shift()!,
    dispose: () => undefined,
  };
});

documentStoreSuite('MemoryDocuments', () => {
  const store = new MemoryDocuments();
  return {
    store,
    edit(key, text) {
      store.edit(key, text);
      return Promise.resolve();
    },
    reopen: () => store,
    dispose: () => undefined,
  };
});
