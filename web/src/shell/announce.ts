// SPDX-License-Identifier: MIT
import { stored } from "./stored";

/** Whether voices that come and go are told to screen readers. */
export const announcing = stored("announce", true, (value) => value !== false);
