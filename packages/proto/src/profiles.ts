import { ComponentIOType } from './generated/messages.ts';

/** Properties of clients, devices, components and modules that profiles can match. */
export interface Profiled {
  readonly id?: string;
  readonly name?: string;
  readonly messageFormat?: string;
  readonly clientId?: string;
  readonly deviceId?: string;
  readonly ioType?: number;
  readonly tags?: readonly string[];
  readonly components?: readonly Profiled[];
  readonly processingModules?: readonly Profiled[];
}

const EQUAL = ['id', 'name', 'messageFormat', 'clientId', 'deviceId'] as const;
const EACH_MET = ['components', 'processingModules'] as const;

/** Whether a candidate has everything that a profile asks for; empty members ask for nothing [CL-20]. */
export function matchesProfile(candidate: Profiled, profile: Profiled): boolean {
  for (const key of EQUAL) {
    if (profile[key] && candidate[key] !== profile[key]) return false;
  }
  // The other value is 0, which is what a profile that does not care has, too.
  if (profile.ioType === ComponentIOType.SUBSCRIBER && candidate.ioType !== profile.ioType) {
    return false;
  }
  for (const tag of profile.tags ?? []) {
    if (!candidate.tags?.includes(tag)) return false;
  }
  for (const key of EACH_MET) {
    for (const part of profile[key] ?? []) {
      if (!candidate[key]?.some((one) => matchesProfile(one, part))) return false;
    }
  }
  return true;
}

/** The candidates that meet at least one of the profiles, each once; all of them when there is no profile [CL-21]. */
export function selectByProfiles<T extends Profiled>(
  candidates: readonly T[],
  profiles: readonly Profiled[],
): T[] {
  if (profiles.length === 0) return [...candidates];
  return candidates.filter((candidate) =>
    profiles.some((profile) => matchesProfile(candidate, profile)),
  );
}
