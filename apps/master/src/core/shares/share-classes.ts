/** Kinds of owners that shares are given to: roles of clients, sessions, and the master itself. */
export type ShareClass = 'master' | 'admin' | 'session' | 'participant' | 'player' | 'viewer';

/** Parts of a limit of the whole master, from 0 to 1. */
export interface ClassShare {
  /** Limit of all owners of the class together. */
  readonly ofAll: number;
  /** Total usage up to which an owner of the class may use more, as a share; the rest is reserved for others. */
  readonly untilFilled: number;
  /** Limit of all clients of one invitation of the class together. */
  readonly perInvitation: number;
}

/**
 * Shares of each class in every resource. [AC-82] An eighth is a reserve for running sessions and admins, half of that
 * for admins alone. Invitations for players and viewers are shown to many people: one of them leaves most to others,
 * and all of them leave half to participants.
 */
export const CLASS_SHARES: { readonly [C in ShareClass]: ClassShare } = {
  master: { ofAll: 1, untilFilled: 1, perInvitation: 1 },
  admin: { ofAll: 1, untilFilled: 1, perInvitation: 1 },
  session: { ofAll: 3 / 4, untilFilled: 15 / 16, perInvitation: 3 / 4 },
  participant: { ofAll: 7 / 8, untilFilled: 7 / 8, perInvitation: 1 / 2 },
  player: { ofAll: 1 / 2, untilFilled: 3 / 4, perInvitation: 1 / 4 },
  viewer: { ofAll: 1 / 4, untilFilled: 3 / 4, perInvitation: 1 / 8 },
};
