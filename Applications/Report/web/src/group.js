import { startGroup } from "./table.js";

startGroup();
