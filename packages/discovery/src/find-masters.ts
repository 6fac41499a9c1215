import { SERVICE_TYPE, fromTxt } from './announcement.ts';
import type { Announcement } from './announcement.ts';
import { openResponder } from './open-responder.ts';
import type { MulticastOptions } from './open-responder.ts';

/** A master that was heard. */
export interface FoundMaster extends Announcement {
  /** Source address of the reply, which can be reached from here. */
  readonly address: string;
  /** Its address for programs: they need no certificate. */
  readonly url: string;
}

/** Options for finding masters. */
export interface FindOptions extends MulticastOptions {
  /** Called for each thing that goes wrong. */
  readonly onProblem: (reason: string) => void;
  /** Called with all masters heard so far, whenever there is another one. */
  readonly onFound: (masters: readonly FoundMaster[]) => void;
}

/** Masters are asked again after so long, milliseconds; then as the last one says. */
const ASK_AGAIN_MS = [250, 1_000, 3_000] as const;

/** Looks for masters until it is ended. [DI-5] @returns ends it */
export function findMasters(options: FindOptions): () => Promise<void> {
  const { addresses, port, onProblem, onFound } = options;
  const found = new Map<string, FoundMaster>();
  const responders = addresses().flatMap(
    (address) => openResponder(address, port, onProblem) ?? [],
  );
  const browsers = responders.map(({ bonjour }) =>
    bonjour.find({ type: SERVICE_TYPE }, (service) => {
      const announcement = fromTxt(service.txt as Record<string, unknown>, service.port);
      const address = service.referer?.address;
      // In several networks at once it is heard several times.
      if (announcement === undefined || address === undefined || found.has(announcement.id)) return;
      const url = `http://${address}:${announcement.port}`;
      found.set(announcement.id, { ...announcement, address, url });
      onFound([...found.values()]);
    }),
  );
  let timer: NodeJS.Timeout;
  const askAgain = (times: number): void => {
    timer = setTimeout(
      () => {
        for (const browser of browsers) browser.update();
        askAgain(times + 1);
      },
      ASK_AGAIN_MS[Math.min(times, ASK_AGAIN_MS.length - 1)],
    );
  };
  askAgain(0);
  return async () => {
    clearTimeout(timer);
    for (const browser of browsers) browser.stop();
    await Promise.all(responders.map((responder) => responder.close()));
  };
}
