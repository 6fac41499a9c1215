import { describeIdentityStorage } from '../../testing/identity-storage-suite.ts';
import { createMemoryIdentity } from './identity.ts';

describeIdentityStorage('memory', () => {
  const storage = createMemoryIdentity();
  return { nextRun: () => storage, close: () => undefined };
});
