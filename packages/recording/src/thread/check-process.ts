import { DiskFolder } from '../node/disk-folder.ts';
import { LocalChecker } from '../recorder/check-file.ts';
import type { RecorderLimits } from '../recorder/recorder-limits.ts';
import type { FromChecker, ToChecker } from './check-messages.ts';

/* The process that checks files: what they do to it, they do to nothing else. [RC-44] */
const [, , folder, limits] = process.argv;
const checker = new LocalChecker(new DiskFolder(folder!), JSON.parse(limits!) as RecorderLimits);
const send = (message: FromChecker): void => void process.send?.(message);

// The terminal and service managers signal all processes of the program: this one ends with its parent.
for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP'] as const) process.on(signal, () => undefined);
process.on('disconnect', () => process.exit());
process.on('message', (job: ToChecker) => {
  checker.check(job).then(
    (verdict) => send({ kind: 'verdict', verdict }),
    (error: unknown) => send({ kind: 'failure', reason: String(error) }),
  );
});
send({ kind: 'ready' });
