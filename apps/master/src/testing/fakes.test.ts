import {
  auditStoreSuite,
  clusterBusSuite,
  documentStoreSuite,
  idSourceSuite,
  logSuite,
  ownerStoreSuite,
  resourceUsageSuite,
  resumeTokensSuite,
} from './acceptance/index.ts';
import {
  FixedUsage,
  MemoryAudit,
  MemoryDocuments,
  MemoryHub,
  MemoryOwnerTable,
  type MemoryOwners,
  PlainTokens,
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

clusterBusSuite('MemoryBus', () => {
  const hub = new MemoryHub();
  return Promise.resolve({
    open: () => Promise.resolve(hub.bus()),
    setReachable(masterId, isReachable) {
      hub.setReachable(masterId, isReachable);
      return Promise.resolve();
    },
    close: () => Promise.resolve(),
  });
});

ownerStoreSuite('MemoryOwners', () => {
  const table = new MemoryOwnerTable();
  let first: MemoryOwners | undefined;
  return Promise.resolve({
    open() {
      const store = table.open();
      first ??= store;
      return Promise.resolve(store);
    },
    setFirstReachable(isReachable) {
      first?.setReachable(isReachable);
      return Promise.resolve();
    },
    close: () => Promise.resolve(),
  });
});
