import { AccessRole } from '@ubii/proto';

import type { AttackEnvironment } from './environment/attack-environment.ts';

/** A role in words. @param role or why there is none */
export function roleName(role: number | string): string {
  if (typeof role === 'string') return `refused (${role.replace(/^.*answered with /, '')})`;
  const name = Object.entries(AccessRole).find(([, value]) => value === role)?.[0] ?? '?';
  return name === 'ACCESS_ROLE_NONE' ? 'stranger' : name.replace('ACCESS_ROLE_', '').toLowerCase();
}

/** `holds`: the aim is met. `breaks`: it is not. `figure`: it has none, others are compared with it. */
export type Verdict = 'holds' | 'breaks' | 'figure';

/** One figure of an attack, with what it should be. */
export interface Finding {
  /** Name of the figure. */
  readonly what: string;
  /** With its unit. */
  readonly figure: string;
  /** The required value, as far as this decides. */
  readonly aim: string;
  readonly verdict: Verdict;
}

/** Something that a caller does to a built master, and what becomes of the others. */
export interface Attack {
  /** For `--only`. */
  readonly name: string;
  readonly about: string;
  /** @throws Error when it could not be tried */
  run(environment: AttackEnvironment): Promise<readonly Finding[]>;
}

/** A finding that holds when the condition does. */
export function finding(what: string, figure: string, aim: string, holds: boolean): Finding {
  return { what, figure, aim, verdict: holds ? 'holds' : 'breaks' };
}

/** A finding for others to be compared with. */
export function comparison(what: string, figure: string): Finding {
  return { what, figure, aim: 'none', verdict: 'figure' };
}

export function seconds(ms: number): string {
  return `${(ms / 1000).toFixed(1)} s`;
}

export function millis(ms: number): string {
  return `${Math.round(ms)} ms`;
}
