import {
  auditStoreSuite,
  clientConnectionSuite,
  documentStoreSuite,
  idSourceSuite,
  logSuite,
  resourceUsageSuite,
  resumeTokensSuite,
} from './acceptance/index.ts';
import {
  FixedUsage,
  MemoryAudit,
  MemoryDocuments,
  PlainTokens,
  RecordingConnection,
  RecordingLog,
  SequentialIds,
} from './index.ts';

const memoryAudit = new MemoryAudit();
auditStoreSuite('MemoryAudit', () => memoryAudit);

idSourceSuite('SequentialIds', () => new SequentialIds());

resumeTokensSuite('PlainTokens', () => new PlainTokens());

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
  };
});
