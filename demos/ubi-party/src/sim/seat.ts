/** A player's place in the room, from 0 to 31. It decides shape, colour and letter. */
export type Seat = number;
