import type { RoleChoice } from '../../joining/connect-phone/grant-choices.ts';

/** Roles of devices of participants: those that read neither studies nor recordings. [ST-5] */
export const DEVICE_ROLES: readonly [RoleChoice, ...RoleChoice[]] = ['player', 'viewer'];
