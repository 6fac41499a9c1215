import { AccessRole } from '@ubii/proto';

/** The role of a caller; `none` for a caller that has not joined [AC-20]. */
export type Role = 'none' | 'admin' | 'participant' | 'player' | 'viewer';

/** A role that an invitation can give. */
export type GivenRole = Exclude<Role, 'none'>;

/** Sets of roles to which rights are given. */
export const ADMINS: readonly GivenRole[] = ['admin'];
export const PARTICIPANTS: readonly GivenRole[] = ['admin', 'participant'];
export const PUBLISHERS: readonly GivenRole[] = ['admin', 'participant', 'player'];
export const READERS: readonly GivenRole[] = ['admin', 'participant', 'viewer'];
export const JOINED: readonly GivenRole[] = ['admin', 'participant', 'player', 'viewer'];

const WIRE: { readonly [R in Role]: AccessRole } = {
  none: AccessRole.ACCESS_ROLE_NONE,
  admin: AccessRole.ACCESS_ROLE_ADMIN,
  participant: AccessRole.ACCESS_ROLE_PARTICIPANT,
  player: AccessRole.ACCESS_ROLE_PLAYER,
  viewer: AccessRole.ACCESS_ROLE_VIEWER,
};

/** The role as it travels. */
export function wireRole(role: Role): AccessRole {
  return WIRE[role];
}

/** The role that this number means; undefined for none and for numbers that mean nothing. */
export function givenRole(wire: number): GivenRole | undefined {
  return JOINED.find((role) => WIRE[role] === wire);
}

/** True for a role that an invitation can give. */
export function isGivenRole(word: unknown): word is GivenRole {
  return JOINED.some((role) => role === word);
}
