import { ClusterMasterState, type ClusterMaster } from '@ubii/proto';

/** A master of the cluster with the name that pages show. */
export interface NamedMaster {
  readonly master: ClusterMaster;
  /** Name, with the address where several masters have the same name. */
  readonly label: string;
}

/** Names the masters of a cluster, in their order. */
export function nameMasters(masters: readonly ClusterMaster[]): NamedMaster[] {
  const hosts = new Map<string, Set<string>>();
  for (const master of masters) {
    const ofName = hosts.get(master.name) ?? new Set();
    hosts.set(master.name, ofName.add(hostOf(master)));
  }
  return masters.map((master) => {
    const { name } = master;
    const isUnique = hosts.get(name)!.size === 1;
    return { master, label: isUnique ? name : `${name} ${hostOf(master)}` };
  });
}

/** Host and port of its best address, otherwise the beginning of its id. */
function hostOf({ addresses, id }: ClusterMaster): string {
  const [best] = addresses;
  return best !== undefined && URL.canParse(best) ? new URL(best).host : id.slice(0, 8);
}

/** True for a master that is not there any more. */
export function isGone({ state }: ClusterMaster): boolean {
  return state === ClusterMasterState.LOST || state === ClusterMasterState.ENDED;
}
