import type { openStorage } from '../storage/open-storage.ts';
import { NatsDocuments } from './nats-documents.ts';
import type { NatsLink } from './nats-link.ts';

/** The stores that all masters share; studies are those of one master. */
export type Storage = Omit<ReturnType<typeof openStorage>, 'studyStorage'>;

/** Name of a bucket. No cluster has `_` in its name, so that no two clusters share a bucket. [CU-54] */
export function bucketOf(cluster: string, kind: string): string {
  return `ubii_${cluster}_${kind}`;
}

/** The stores of a cluster: the same documents for every master, in buckets of NATS. [CU-54] */
export async function openClusterStorage(
  link: NatsLink,
  cluster: string,
): Promise<Storage & { close(): void }> {
  const opened: NatsDocuments[] = [];
  const open = async (kind: string): Promise<NatsDocuments> => {
    const store = await NatsDocuments.open(link, bucketOf(cluster, kind));
    opened.push(store);
    return store;
  };
  const close = (): void => opened.forEach((store) => store.close());
  try {
    const [sessions, modules, running, history, grants, personalData] = await Promise.all([
      open('sessions'),
      open('modules'),
      open('running'),
      open('history'),
      open('grants'),
      open('personal-data'),
    ]);
    return {
      sessions,
      modules,
      running,
      history,
      grants,
      personalData,
      async settled() {
        await Promise.all(opened.map((store) => store.settled()));
      },
      close,
    };
  } catch (error) {
    // Those that are still being opened end with the link.
    close();
    throw error;
  }
}
