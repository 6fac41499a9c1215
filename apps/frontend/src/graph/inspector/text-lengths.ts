/** Longest texts of a session that a master accepts, characters [EX-70]. */
export const MAX_LENGTH = { name: 256, topic: 1024, pattern: 1024, description: 4096 } as const;
