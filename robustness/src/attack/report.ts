import type { Finding } from './attack.ts';

/** Result of one attack. */
export interface AttackReport {
  readonly attack: string;
  readonly about: string;
  readonly findings: readonly Finding[];
  /** Why it could not be tried. */
  readonly problem?: string;
}

/** One attack as lines of text. */
export function formatReport({ attack, about, findings, problem }: AttackReport): string {
  const rows = findings.map(
    ({ what, figure, aim, verdict }) =>
      `  ${verdict.padEnd(7)} ${what}: ${figure}${verdict === 'figure' ? '' : ` (aim: ${aim})`}`,
  );
  if (problem !== undefined) rows.push(`  untried could not be tried: ${problem}`);
  return [`${attack}: ${about}`, ...rows].join('\n');
}
