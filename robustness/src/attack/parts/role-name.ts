import { AccessRole } from '@ubii/proto';

/** A role in words. @param role or why there is none */
export function roleName(role: number | string): string {
  if (typeof role === 'string') return `refused (${role.replace(/^.*answered with /, '')})`;
  const name = Object.entries(AccessRole).find(([, value]) => value === role)?.[0] ?? '?';
  return name === 'ACCESS_ROLE_NONE' ? 'stranger' : name.replace('ACCESS_ROLE_', '').toLowerCase();
}
